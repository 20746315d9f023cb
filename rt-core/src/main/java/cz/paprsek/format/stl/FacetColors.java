package cz.paprsek.format.stl;

import java.nio.charset.StandardCharsets;

/**
 * The colours that programs hide in the two bytes after each triangle: five bits for each channel and one more.
 *
 * @param isMagics whether red is in the lowest bits, and the highest one, with all others or alone, says that the triangle has the colour of all (MeshLab sets it always); else blue is,
 *     and that bit says that there is a colour
 * @param common the colour of all, sRGB, a byte for each channel
 * @source Materialise Magics and VisCAM, as described in Wikipedia, STL (file format), Colour in binary STL
 */
record FacetColors(boolean isMagics, int common) {
    private static final int WHITE = 0xFFFFFF;
    private static final String MARK = "COLOR=";
    private static final int HEAD = 80;
    private static final int CHOSEN = 0x8000;
    private static final int ALL = 0xFFFF;

    /** By the head of a file. */
    static FacetColors of(byte[] head) {
        int at = new String(head, 0, HEAD, StandardCharsets.ISO_8859_1).indexOf(MARK) + MARK.length();
        boolean isMagics = at >= MARK.length() && at + 3 <= HEAD;
        return new FacetColors(isMagics, isMagics ? (head[at] & 255) << 16 | (head[at + 1] & 255) << 8 | (head[at + 2] & 255) : WHITE);
    }

    int of(int bits) {
        boolean isCommon = isMagics ? bits == CHOSEN || bits == ALL : (bits & CHOSEN) == 0;
        int low = channel(bits);
        int high = channel(bits >> 10);
        return isCommon ? common : isMagics ? low << 16 | channel(bits >> 5) << 8 | high : high << 16 | channel(bits >> 5) << 8 | low;
    }

    private static int channel(int bits) {
        return (int) Math.rint((bits & 31) * 255 / 31.0);
    }
}
