package cz.paprsek.sheet.pdf;

import cz.paprsek.shape.font.Font;
import cz.paprsek.shape.font.Fonts;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * One of the shipped fonts in a PDF: how wide texts are, and the objects that hold it. Letters are shown by the numbers of their glyphs; a table says which
 * characters these are, so that text can be found and copied.
 *
 * @source ISO 32000-1, 9.7 (composite fonts) and 9.10.3 (ToUnicode)
 */
final class PdfFont {
    /** In thousandths of the size, as these fonts have it. */
    private static final String MEASURES = "/FontBBox [-1021 -463 1793 1232] /ItalicAngle 0 /Ascent 928 /Descent -236 /CapHeight 729 /StemV 80";
    /** As many lines as a block of the table of characters may have. */
    private static final int BLOCK = 100;

    private final String file;
    private final String name;
    private final Font font;
    /** The glyphs that have been shown, with their characters. */
    private final Map<Integer, Integer> used = new TreeMap<>();

    /** @param file its name among those that are shipped */
    PdfFont(String file) {
        this.file = file;
        this.name = "PAPRSK+Paprsek-" + file;
        this.font = Fonts.shipped(file).orElseThrow(() -> new IllegalArgumentException("there is no font " + file));
    }

    /** How wide a text is. */
    double width(String text, double size) {
        return text.codePoints().mapToDouble(c -> thousandths(font.glyph(c))).sum() * size / 1000;
    }

    private double thousandths(int glyph) {
        return Math.rint(1000.0 * font.width(glyph) / font.unitsPerEm());
    }

    /** A text as the numbers of its glyphs, for {@code Tj}. */
    String shown(String text) {
        StringBuilder hex = new StringBuilder("<");
        text.codePoints().forEach(c -> {
            int glyph = font.glyph(c);
            used.put(glyph, c);
            hex.append(String.format("%04X", glyph));
        });
        return hex.append('>').toString();
    }

    /**
     * The objects, of which the first is the font.
     *
     * @param first its number; the others follow
     */
    List<byte[]> objects(int first) {
        List<byte[]> objects = new ArrayList<>();
        objects.add(text("<< /Type /Font /Subtype /Type0 /BaseFont /" + name + " /Encoding /Identity-H /DescendantFonts [" + (first + 1) + " 0 R] /ToUnicode " + (first + 4) + " 0 R >>"));
        StringBuilder widths = new StringBuilder();
        used.keySet().forEach(glyph -> widths.append(glyph).append(" [").append((int) thousandths(glyph)).append("] "));
        objects.add(text("<< /Type /Font /Subtype /CIDFontType2 /BaseFont /" + name + " /CIDSystemInfo << /Registry (Adobe) /Ordering (Identity) /Supplement 0 >> /FontDescriptor " + (first + 2)
                + " 0 R /DW 600 /W [" + widths + "] /CIDToGIDMap /Identity >>"));
        objects.add(text("<< /Type /FontDescriptor /FontName /" + name + " /Flags 4 " + MEASURES + " /FontFile2 " + (first + 3) + " 0 R >>"));
        byte[] bytes = Fonts.file(file);
        objects.add(Pdf.stream("/Length1 " + bytes.length, bytes));
        objects.add(Pdf.stream("", text(characters())));
        return objects;
    }

    private String characters() {
        StringBuilder table = new StringBuilder("""
                /CIDInit /ProcSet findresource begin
                12 dict begin
                begincmap
                /CIDSystemInfo << /Registry (Adobe) /Ordering (UCS) /Supplement 0 >> def
                /CMapName /Adobe-Identity-UCS def
                /CMapType 2 def
                1 begincodespacerange
                <0000> <FFFF>
                endcodespacerange
                """);
        List<Map.Entry<Integer, Integer>> all = List.copyOf(used.entrySet());
        for (int from = 0; from < all.size(); from += BLOCK) {
            List<Map.Entry<Integer, Integer>> block = all.subList(from, Math.min(all.size(), from + BLOCK));
            table.append(block.size()).append(" beginbfchar\n");
            block.forEach(one -> table.append(String.format("<%04X> <%s>\n", one.getKey(), utf16(one.getValue()))));
            table.append("endbfchar\n");
        }
        return table.append("endcmap\nCMapName currentdict /CMap defineresource pop\nend\nend\n").toString();
    }

    private static String utf16(int character) {
        StringBuilder hex = new StringBuilder();
        for (char c : Character.toChars(character)) {
            hex.append(String.format("%04X", (int) c));
        }
        return hex.toString();
    }

    private static byte[] text(String ascii) {
        return ascii.getBytes(StandardCharsets.US_ASCII);
    }
}
