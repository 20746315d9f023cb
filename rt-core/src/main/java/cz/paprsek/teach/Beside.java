package cz.paprsek.teach;

import cz.paprsek.image.Image;
import cz.paprsek.io.Json;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.mistake.Mistake;
import cz.paprsek.teach.mistake.Mistakes;
import cz.paprsek.text.Numbers;
import cz.paprsek.words.Words;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/** The numbers of a pixel with mistakes beside the right ones. */
public final class Beside {
    private static final double ROUNDING = 1e-12;

    private final Mistakes made;
    private final int column;
    private final int row;
    private final Map<String, double[]> right;
    private final Map<String, double[]> wrong;

    /**
     * Of the ray through the middle of a pixel.
     *
     * @throws IllegalArgumentException if there is no such pixel, or the plain tracer does not know all of the scene
     */
    public Beside(Scene scene, RenderSettings settings, Mistakes made, int column, int row) {
        this.made = Objects.requireNonNull(made, "made");
        this.column = column;
        this.row = row;
        right = PlainTracer.of(scene, settings, Mistakes.NONE).numbers(column, row);
        wrong = PlainTracer.of(scene, settings, made).numbers(column, row);
    }

    /** The mistakes, each with its line of the derivation, and then all numbers, those that differ marked by an asterisk. */
    public List<String> lines(Words words) {
        List<String> lines = new ArrayList<>();
        for (Mistake mistake : made.all()) {
            lines.add(mistake + ": " + mistake.meaning(words));
            lines.add("  " + words.of("beside.right") + "  " + mistake.right(words));
            lines.add("  " + words.of("beside.wrong") + "  " + mistake.wrong(words));
        }
        lines.add(words.of("beside.pixel", column, row));
        lines.add(line(" ", "", words.of("beside.right"), words.of("beside.wrong")));
        for (String name : names()) {
            lines.add(line(differs(name) ? "*" : " ", name.equals(Tracer.RAY) ? words.of("beside.ray") : name, words.figures(text(right.get(name))), words.figures(text(wrong.get(name)))));
        }
        lines.add(line(" ", "sRGB", shown(right), shown(wrong)));
        return lines;
    }

    /** The same for programs. */
    public Json json() {
        Json ofRight = new Json();
        right.forEach(ofRight::withNumbers);
        Json ofWrong = new Json();
        wrong.forEach(ofWrong::withNumbers);
        return new Json().withTexts("mistakes", made.all().stream().map(Mistake::toString).toList()).with("column", column).with("row", row)
                .with("right", ofRight).with("wrong", ofWrong).withTexts("different", names().stream().filter(this::differs).toList());
    }

    private List<String> names() {
        List<String> names = new ArrayList<>(right.keySet());
        new TreeSet<>(wrong.keySet()).stream().filter(name -> !names.contains(name)).forEach(names::add);
        names.remove("B");
        names.add("B");
        return names;
    }

    private boolean differs(String name) {
        double[] a = right.get(name);
        double[] b = wrong.get(name);
        if (a == null || b == null) {
            return true;
        }
        for (int i = 0; i < a.length; i++) {
            if (!(Math.abs(a[i] - b[i]) <= ROUNDING * (1 + Math.abs(a[i])))) {
                return true;
            }
        }
        return false;
    }

    private static String line(String mark, String name, String right, String wrong) {
        return String.format(Locale.ROOT, "%s %-12s %-34s %s", mark, name, right, wrong).stripTrailing();
    }

    private static String text(double @Nullable [] values) {
        return values == null ? "-" : Arrays.stream(values).mapToObj(value -> Numbers.text(Math.rint(value * 1e5) / 1e5)).collect(Collectors.joining(" "));
    }

    private static String shown(Map<String, double[]> numbers) {
        double[] light = Objects.requireNonNull(numbers.get("B"));
        Image one = new Image(1, 1);
        one.set(0, 0, light[0], light[1], light[2]);
        int argb = one.argb(0, 0);
        return (argb >> 16 & 0xFF) + " " + (argb >> 8 & 0xFF) + " " + (argb & 0xFF);
    }
}
