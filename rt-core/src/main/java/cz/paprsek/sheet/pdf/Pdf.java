package cz.paprsek.sheet.pdf;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.zip.DeflaterOutputStream;

/**
 * A document of A4 pages, written without anything that would differ if it were made again: no clock, no number of its own.
 *
 * @source ISO 32000-1 (PDF 1.7)
 */
public final class Pdf {
    /** In points, of which an inch has 72. */
    public static final double WIDTH = 595.28;
    /** Likewise. */
    public static final double HEIGHT = 841.89;

    private final String title;
    private final String language;
    private final PdfFont plain = new PdfFont("sans");
    private final PdfFont bold = new PdfFont("sans-bold");
    private final List<PdfPage> pages = new ArrayList<>();

    /** @param language such as {@code en} */
    public Pdf(String title, String language) {
        this.title = Objects.requireNonNull(title, "title");
        this.language = Objects.requireNonNull(language, "language");
    }

    /** Begins another page. */
    public PdfPage page() {
        PdfPage page = new PdfPage(plain, bold);
        pages.add(page);
        return page;
    }

    /** How many pages there are. */
    public int pages() {
        return pages.size();
    }

    /** How wide a text is, points. */
    public double width(String text, double size, boolean isBold) {
        return (isBold ? bold : plain).width(text, size);
    }

    /** The whole file. */
    public byte[] bytes() {
        List<byte[]> objects = new ArrayList<>();
        int fonts = 4;
        List<byte[]> ofPlain = plain.objects(fonts);
        List<byte[]> ofBold = bold.objects(fonts + ofPlain.size());
        int first = fonts + ofPlain.size() + ofBold.size();
        StringBuilder kids = new StringBuilder();
        for (int i = 0; i < pages.size(); i++) {
            kids.append(first + 2 * i).append(" 0 R ");
        }
        objects.add(ascii("<< /Type /Catalog /Pages 2 0 R /Lang (" + language + ") /ViewerPreferences << /DisplayDocTitle true >> >>"));
        objects.add(ascii("<< /Type /Pages /Kids [" + kids + "] /Count " + pages.size() + " /MediaBox [0 0 " + number(WIDTH) + " " + number(HEIGHT) + "] /Resources << /Font << /F1 " + fonts
                + " 0 R /F2 " + (fonts + ofPlain.size()) + " 0 R >> >> >>"));
        objects.add(ascii("<< /Title " + utf16(title) + " /Producer (Paprsek) >>"));
        objects.addAll(ofPlain);
        objects.addAll(ofBold);
        for (int i = 0; i < pages.size(); i++) {
            objects.add(ascii("<< /Type /Page /Parent 2 0 R /Contents " + (first + 2 * i + 1) + " 0 R >>"));
            objects.add(stream("", ascii(pages.get(i).content())));
        }
        return file(objects);
    }

    private static byte[] file(List<byte[]> objects) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        // Four bytes that no text has, so that nobody who passes the file on takes it for one.
        out.writeBytes("%PDF-1.7\n%\u00e2\u00e3\u00cf\u00d3\n".getBytes(StandardCharsets.ISO_8859_1));
        StringBuilder places = new StringBuilder("0000000000 65535 f \n");
        for (int i = 0; i < objects.size(); i++) {
            places.append(String.format(Locale.ROOT, "%010d 00000 n \n", out.size()));
            out.writeBytes(ascii((i + 1) + " 0 obj\n"));
            out.writeBytes(objects.get(i));
            out.writeBytes(ascii("\nendobj\n"));
        }
        int table = out.size();
        out.writeBytes(ascii("xref\n0 " + (objects.size() + 1) + "\n" + places + "trailer\n<< /Size " + (objects.size() + 1) + " /Root 1 0 R /Info 3 0 R >>\nstartxref\n" + table + "\n%%EOF\n"));
        return out.toByteArray();
    }

    /** Content, compressed. */
    static byte[] stream(String more, byte[] plain) {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DeflaterOutputStream packing = new DeflaterOutputStream(packed)) {
            packing.write(plain);
        } catch (IOException e) {
            throw new UncheckedIOException("bytes in memory could not be written", e);
        }
        byte[] content = packed.toByteArray();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(ascii("<< /Length " + content.length + " /Filter /FlateDecode" + (more.isEmpty() ? "" : " " + more) + " >>\nstream\n"));
        out.writeBytes(content);
        out.writeBytes(ascii("\nendstream"));
        return out.toByteArray();
    }

    /** To a hundredth of a point, which no printer shows. */
    static String number(double value) {
        String text = String.format(Locale.ROOT, "%.2f", value + 0.0);
        return text.equals("-0.00") ? "0.00" : text;
    }

    private static String utf16(String text) {
        StringBuilder hex = new StringBuilder("<FEFF");
        text.chars().forEach(c -> hex.append(String.format("%04X", c)));
        return hex.append('>').toString();
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }
}
