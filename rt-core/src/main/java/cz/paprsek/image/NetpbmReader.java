package cz.paprsek.image;

import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.io.BinaryInput;
import cz.paprsek.io.PlainText;
import cz.paprsek.material.Rgb;
import cz.paprsek.text.Numbers;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * Reads binary portable maps: PF and Pf as linear light, P5 and P6 as sRGB, as everybody writes them. P5 and P6 are linear light if a comment of
 * the head says so, as in what is written here; if the file is called so ({@code .ppm16}), as those were that said nothing; and, of 16 bits, if the
 * comment says that POV-Ray wrote them, which does not tell: it does so with a file gamma of 1 when it is to be compared with.
 *
 * @source Netpbm, ppm(5), pgm(5); Debevec, PFM
 */
final class NetpbmReader {
    private static final String POV_RAY = " Software: POV-Ray";
    private static final int LONGEST_COMMENT = 100_000;

    private final BinaryInput input;
    private boolean isLinear;
    private boolean isByPovRay;

    private NetpbmReader(BinaryInput input, boolean isLinear) {
        this.input = input;
        this.isLinear = isLinear;
    }

    static boolean canRead(byte[] start) {
        return start.length > 2 && start[0] == 'P' && "56Ff".indexOf(start[1]) >= 0 && start[2] <= ' ';
    }

    /** @param isLinear whether it is linear light for certain, whatever the head says */
    static StoredImage read(BinaryInput input, boolean isLinear) throws IOException {
        return new NetpbmReader(input, isLinear).read();
    }

    private StoredImage read() throws IOException {
        String magic = word();
        int width = whole("width", 1 << 16);
        int height = whole("height", 1 << 16);
        boolean isGrey = magic.equals("P5") || magic.equals("Pf");
        if (magic.equals("P5") || magic.equals("P6")) {
            int last = whole("largest value", 65_535);
            boolean isLight = isLinear || (isByPovRay && last > 255);
            double[] light = light(last, isLight);
            Image image = last < 256
                    ? fill(width, height, isGrey, false, 1, row -> light[Math.min(last, row.get() & 0xFF)])
                    : fill(width, height, isGrey, false, 2, row -> light[Math.min(last, row.getShort() & 0xFFFF)]);
            return new StoredImage(image, last < 256 ? Precision.EIGHT_BIT : Precision.SIXTEEN_BIT, isGrey, isLight ? 1 : StoredImage.SRGB);
        }
        boolean isLittle = number(word()) < 0;
        Image image = fill(width, height, isGrey, true, 4, row -> isLittle ? Float.intBitsToFloat(Integer.reverseBytes(row.getInt())) : row.getFloat());
        return new StoredImage(image, Precision.FLOAT, isGrey);
    }

    private static double[] light(int last, boolean isLinear) {
        double[] light = new double[last + 1];
        for (int i = 0; i <= last; i++) {
            light[i] = isLinear ? i / (double) last : Rgb.linear(i * 255.0 / last);
        }
        return light;
    }

    private interface Value {
        double next(ByteBuffer row);
    }

    private Image fill(int width, int height, boolean isGrey, boolean fromBelow, int bytes, Value value) throws IOException {
        int length = width * bytes * (isGrey ? 1 : 3);
        input.require("a picture of " + width + " × " + height + " pixels", input.position() + (long) length * height);
        Image image = ReadLimits.blank(width, height);
        byte[] row = new byte[length];
        for (int i = 0; i < height; i++) {
            input.fill(row, 0, length);
            ByteBuffer values = ByteBuffer.wrap(row);
            for (int x = 0; x < width; x++) {
                double red = value.next(values);
                double green = isGrey ? red : value.next(values);
                double blue = isGrey ? red : value.next(values);
                image.set(x, fromBelow ? height - 1 - i : i, red, green, blue);
            }
        }
        return image;
    }

    private int whole(String what, int most) throws IOException {
        double value = number(word());
        if (!(value >= 1 && value <= most && value == Math.rint(value))) {
            throw new IOException("the picture's " + what + " must be a whole number from 1 to " + most);
        }
        return (int) value;
    }

    private static double number(String word) throws IOException {
        return Numbers.parsed(word).orElseThrow(() -> new IOException("the picture's head should have a number where it has \"" + PlainText.of(word, 32) + "\""));
    }

    /** The next word of the head, and the one blank after it; comments run from # to the end of the line. */
    private String word() throws IOException {
        StringBuilder word = new StringBuilder();
        while (word.length() < 32) {
            int c = input.u8();
            if (c == '#' && word.length() == 0) {
                heed(input.textUpTo('\n', LONGEST_COMMENT));
            } else if (c > ' ') {
                word.append(new String(new byte[] {(byte) c}, StandardCharsets.ISO_8859_1));
            } else if (word.length() > 0) {
                return word.toString();
            }
        }
        throw new IOException("the picture's head should have a number where it has \"" + PlainText.of(word.toString(), 32) + "…\"");
    }

    private void heed(String comment) {
        isLinear |= comment.strip().equals(Netpbm.LINEAR);
        isByPovRay |= comment.startsWith(POV_RAY);
    }
}
