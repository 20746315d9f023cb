package cz.paprsek.render.explain.text;

import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.words.Words;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** A pixel's tree as lines of text: every ray a worked exercise, in columns, the rays it gives rise to below it. */
public final class TreeText {
    /** The column of formulas is not made wider than this for the sake of a few long ones. */
    private static final int WIDEST_FORMULA = 32;
    private static final int NAME = 14;

    private final Words words;
    private final Decoration decoration;
    private final double smallestShare;
    private final List<String> lines = new ArrayList<>();
    private int nameWidth = NAME;
    private int formulaWidth;

    private TreeText(Words words, Decoration decoration, double smallestShare) {
        this.words = words;
        this.decoration = decoration;
        this.smallestShare = smallestShare;
    }

    /**
     * The tree in English, without line ends.
     *
     * @param smallestShare rays of a {@linkplain Outline#share share} below this are only mentioned, and of several rays from the eye only the
     *     {@linkplain Pixel#typical typical} one is told in full; 0 for all
     */
    public static List<String> lines(Pixel pixel, double smallestShare, Decoration decoration) {
        return lines(pixel, smallestShare, decoration, Words.ENGLISH);
    }

    /** The same in any language. */
    public static List<String> lines(Pixel pixel, double smallestShare, Decoration decoration, Words words) {
        TreeText text = new TreeText(words, decoration, smallestShare);
        List<Outline> outlines = pixel.rays().stream().map(Outline::of).toList();
        boolean isOneOfSeveral = outlines.size() > 1 && smallestShare > 0;
        int first = isOneOfSeveral ? pixel.typical() : 0;
        int end = isOneOfSeveral ? first + 1 : outlines.size();
        outlines.subList(first, end).forEach(text::measure);
        for (int i = first; i < end; i++) {
            if (outlines.size() > 1) {
                text.lines.add(words.of("ray-of", i + 1, outlines.size()) + (isOneOfSeveral ? words.of("nearest-to-pixel") : ""));
            }
            text.ray(outlines.get(i), "", "");
            text.lines.add("");
        }
        text.total(pixel, outlines);
        return text.lines;
    }

    private void measure(Outline outline) {
        if (isMentionedOnly(outline)) {
            return;
        }
        for (Step step : outline.steps(words)) {
            nameWidth = Math.max(nameWidth, length(step.name()));
            if (!step.result().isEmpty()) {
                formulaWidth = Math.max(formulaWidth, Math.min(WIDEST_FORMULA, length(step.formula())));
            }
        }
        outline.children().forEach(this::measure);
    }

    private boolean isMentionedOnly(Outline outline) {
        return outline.share() < smallestShare && outline.ray().level() > 1;
    }

    private void ray(Outline outline, String first, String rest) {
        TracedRay ray = outline.ray();
        String patch = decoration.patch(ray.light());
        lines.add(decoration.branch(first) + decoration.headline(ray.kind(), outline.name() + "  " + outline.headline(words))
                + "  " + outline.percent(words) + (patch.isEmpty() ? "" : "  " + patch));
        if (isMentionedOnly(outline)) {
            int below = outline.descendants();
            lines.add(decoration.branch(rest + "  ") + words.of("too-small") + (below > 0 ? words.of("below", below) : ""));
            return;
        }
        List<Outline> children = outline.children();
        for (Step step : outline.steps(words)) {
            lines.add((decoration.branch(rest + (children.isEmpty() ? "  " : "│ ")) + line(step)).stripTrailing());
        }
        for (int i = 0; i < children.size(); i++) {
            boolean isLast = i == children.size() - 1;
            lines.add(decoration.branch(rest + "│"));
            ray(children.get(i), rest + (isLast ? "└─" : "├─"), rest + (isLast ? "  " : "│ "));
        }
    }

    private String line(Step step) {
        return decoration.name(step.topic(), padded(step.name(), nameWidth)) + " "
                + decoration.formula(step.result().isEmpty() ? step.formula() : padded(step.formula(), formulaWidth))
                + decoration.numbers(step.numbers().isEmpty() ? "" : " = " + step.numbers())
                + (step.result().isEmpty() ? "" : " = " + decoration.result(step.topic(), step.result()));
    }

    /** What a pixel's light is, in one line: that of its ray, or what its rays make together. */
    public static String sum(Pixel pixel, Words words) {
        int rays = pixel.rays().size();
        return (rays > 1 ? words.of(pixel.isSharpened() ? "the-weighted" : "the-average", rays) : words.of("the-light")) + " = " + words.figures(Figures.of(pixel.light())
                + Figures.shown(pixel.developed(), pixel.exposure(), pixel.tone(), words));
    }

    /** What one of a pixel's rays, counted from 0, brings, in one line: where it goes through the pixel, its light and how much of it the pixel gets. */
    public static String sample(Pixel pixel, int ray, Words words) {
        return words.of("ray-of", ray + 1, pixel.rays().size()) + "  " + words.figures(place(pixel, ray) + "  " + weighed(pixel, ray));
    }

    private static String place(Pixel pixel, int ray) {
        return Figures.pair(pixel.places().get(ray).x(), pixel.places().get(ray).y());
    }

    private static String weighed(Pixel pixel, int ray) {
        return Figures.of(pixel.rays().get(ray).light()) + " · " + Figures.of(pixel.weights().get(ray));
    }

    private void total(Pixel pixel, List<Outline> outlines) {
        if (pixel.rays().size() > 1) {
            samples(pixel, outlines);
        }
        String patch = decoration.patch(pixel.developed());
        lines.add(words.of("pixel", pixel.column(), pixel.row()) + ": " + sum(pixel, words) + (patch.isEmpty() ? "" : "  " + patch));
    }

    /** Where each ray goes through the pixel, its light, how much of it the pixel gets, and what the ray meets, a line each. */
    private void samples(Pixel pixel, List<Outline> outlines) {
        int placeWidth = IntStream.range(0, outlines.size()).map(i -> length(place(pixel, i))).max().orElse(0);
        int lightWidth = IntStream.range(0, outlines.size()).map(i -> length(weighed(pixel, i))).max().orElse(0);
        for (int i = 0; i < outlines.size(); i++) {
            String patch = decoration.patch(outlines.get(i).ray().light());
            lines.add(padded(words.of("ray-of", i + 1, outlines.size()), nameWidth) + " " + words.figures(padded(place(pixel, i), placeWidth) + "  " + padded(weighed(pixel, i), lightWidth)) + "  "
                    + outlines.get(i).headline(words) + (patch.isEmpty() ? "" : "  " + patch));
        }
    }

    private static String padded(String text, int width) {
        return text + " ".repeat(Math.max(0, width - length(text)));
    }

    private static int length(String text) {
        return text.codePointCount(0, text.length());
    }
}
