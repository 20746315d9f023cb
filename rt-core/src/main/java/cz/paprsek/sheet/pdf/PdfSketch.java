package cz.paprsek.sheet.pdf;

import cz.paprsek.xml.bind.PlainElements;
import cz.paprsek.xml.bind.PlainElements.Element;
import cz.paprsek.xml.bind.PlainElements.Refused;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** A drawing of rays, which is SVG of few kinds (rectangles, straight paths, lines, texts), on a page. */
public final class PdfSketch {
    private final Element svg;

    /** @param svg a drawing of {@link cz.paprsek.drawing.TreeDrawing} */
    public PdfSketch(String svg) {
        try {
            this.svg = PlainElements.read(svg.getBytes(StandardCharsets.UTF_8));
        } catch (Refused | IOException own) {
            throw new IllegalArgumentException("this is no drawing of rays: " + own.getMessage(), own);
        }
    }

    /** How high it is if it is so wide. */
    public double height(double width) {
        return width * number(svg, "height") / number(svg, "width");
    }

    /** Draws it, by its top left corner. */
    public void draw(PdfPage page, double left, double top, double width) {
        Pen pen = new Pen(page, left, top, width / number(svg, "width"), number(svg, "font-size"));
        svg.children().forEach(pen::draw);
    }

    private static double number(Element element, String attribute) {
        return Double.parseDouble(element.attributes().getOrDefault(attribute, "0"));
    }

    private record Pen(PdfPage page, double left, double top, double scale, double size) {
        void draw(Element element) {
            switch (element.name()) {
                case "rect" -> rectangle(element);
                case "path" -> path(element);
                case "line" -> stroke(element, List.of(List.of(at(number(element, "x1"), number(element, "y1")), at(number(element, "x2"), number(element, "y2")))));
                case "text" -> {
                    double[] at = at(number(element, "x"), number(element, "y"));
                    page.text(at[0], at[1], scale * size, false, color(element, "fill"), element.text().toString());
                }
                default -> throw new IllegalArgumentException("a drawing of rays has no " + element.name());
            }
        }

        private void rectangle(Element element) {
            double x = number(element, "x");
            double y = number(element, "y");
            double right = x + number(element, "width");
            double bottom = y + number(element, "height");
            List<double[]> corners = List.of(at(x, y), at(right, y), at(right, bottom), at(x, bottom), at(x, y));
            page.fill(corners, color(element, "fill"));
            if (element.attributes().containsKey("stroke")) {
                stroke(element, List.of(corners));
            }
        }

        /** M, L and Z with places after each. */
        private void path(Element element) {
            List<List<double[]>> stretches = new ArrayList<>();
            for (String word : element.attributes().getOrDefault("d", "").strip().split("\\s+", -1)) {
                if (word.startsWith("M")) {
                    stretches.add(new ArrayList<>());
                }
                if (!word.equals("Z")) {
                    String[] place = word.substring(1).split(",", -1);
                    stretches.get(stretches.size() - 1).add(at(Double.parseDouble(place[0]), Double.parseDouble(place[1])));
                }
            }
            if (element.attributes().getOrDefault("fill", "none").equals("none")) {
                stroke(element, stretches);
            } else {
                stretches.forEach(stretch -> page.fill(stretch, color(element, "fill")));
            }
        }

        private void stroke(Element element, List<List<double[]>> stretches) {
            String dashes = element.attributes().getOrDefault("stroke-dasharray", "");
            double width = element.attributes().containsKey("stroke-width") ? number(element, "stroke-width") : 1;
            page.stroke(stretches, scale * width, color(element, "stroke"),
                    dashes.isEmpty() ? List.of() : Arrays.stream(dashes.split(" ", -1)).map(dash -> scale * Double.parseDouble(dash)).toList());
        }

        private static String color(Element element, String attribute) {
            return element.attributes().getOrDefault(attribute, "#000000");
        }

        private double[] at(double x, double y) {
            return new double[] {left + scale * x, top + scale * y};
        }
    }
}
