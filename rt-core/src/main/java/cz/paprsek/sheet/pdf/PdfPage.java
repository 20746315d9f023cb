package cz.paprsek.sheet.pdf;

import java.util.List;

/** What is drawn on a page. Places are in points from its top left corner, y down; colours as {@code #rrggbb}. */
public final class PdfPage {
    private final PdfFont plain;
    private final PdfFont bold;
    private final StringBuilder content = new StringBuilder();

    PdfPage(PdfFont plain, PdfFont bold) {
        this.plain = plain;
        this.bold = bold;
    }

    String content() {
        return content.toString();
    }

    /** A line of text, by the left end of its base line. */
    public void text(double x, double y, double size, boolean isBold, String color, String text) {
        content.append("BT /").append(isBold ? "F2 " : "F1 ").append(Pdf.number(size)).append(" Tf ").append(rgb(color)).append(" rg 1 0 0 1 ").append(at(x, y)).append(" Tm ")
                .append((isBold ? bold : plain).shown(text)).append(" Tj ET\n");
    }

    /**
     * A path of straight lines.
     *
     * @param stretches of each the points, x and y
     * @param width of the line
     * @param dashes on, off, on … points; none for a whole line
     */
    public void stroke(List<List<double[]>> stretches, double width, String color, List<Double> dashes) {
        content.append("q ").append(rgb(color)).append(" RG ").append(Pdf.number(width)).append(" w [");
        dashes.forEach(dash -> content.append(Pdf.number(dash)).append(' '));
        content.append("] 0 d ");
        stretches.forEach(this::path);
        content.append("S Q\n");
    }

    /** An area within straight lines. */
    public void fill(List<double[]> corners, String color) {
        content.append("q ").append(rgb(color)).append(" rg ");
        path(corners);
        content.append("h f Q\n");
    }

    private void path(List<double[]> points) {
        for (int i = 0; i < points.size(); i++) {
            content.append(at(points.get(i)[0], points.get(i)[1])).append(i == 0 ? " m " : " l ");
        }
    }

    private static String at(double x, double y) {
        return Pdf.number(x) + " " + Pdf.number(Pdf.HEIGHT - y);
    }

    private static String rgb(String color) {
        int value = Integer.parseInt(color.substring(1), 16);
        return Pdf.number((value >> 16 & 255) / 255.0) + " " + Pdf.number((value >> 8 & 255) / 255.0) + " " + Pdf.number((value & 255) / 255.0);
    }
}
