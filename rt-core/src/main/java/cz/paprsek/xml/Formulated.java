package cz.paprsek.xml;

import cz.paprsek.math.Require;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.recipe.Script;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Puts formulas where numbers stand in a file. Where that is, two texts of the scene with different numbers there tell: so there is no table of what in a
 * scene is which number of a file.
 */
final class Formulated {
    private static final Pattern NUMBER = Pattern.compile("-?[0-9]+(?:\\.[0-9]+)?(?:[eE][-+]?[0-9]+)?");
    /** What is added to the value, and what it is multiplied by, to have others: some will be refused, or what is not written because it is usual. */
    private static final double[][] OTHERS = {{1, 1}, {2, 1}, {-1, 1}, {-2, 1}, {0, 0.5}, {0, 0.75}, {0, 0.25}, {0.125, 1}, {-0.125, 1}};

    private Formulated() {}

    /** Of what is repeated, copies follow the first. */
    static Scene of(Scene scene, DoubleFunction<Scene> change, String formula) {
        double value = (scene.recipe().isNone() ? Script.valueOfPlain(formula) : Settled.script(scene.recipe()).value(formula)) + 0.0;
        Optional<Scene> followed = scene.recipe().text().contains("<repeat") ? with(number -> Settled.following(change.apply(number)), value, formula) : Optional.empty();
        return followed.or(() -> with(change, value, formula)).orElseThrow(() -> new IllegalArgumentException("no formula can stand here"));
    }

    /** Empty if another number changes nothing, or more than numbers. */
    private static Optional<Scene> with(DoubleFunction<Scene> change, double value, String formula) {
        Scene wanted = change.apply(value);
        List<String> others = new ArrayList<>();
        for (double[] other : OTHERS) {
            Optional<String> text = text(change, value * other[1] + other[0]);
            if (text.isPresent()) {
                Require.that(text.get().length() <= Making.LONGEST, "a scene as large as this cannot have formulas");
                for (String one : others) {
                    Optional<String> told = told(one, text.get(), "{" + formula + "}");
                    if (told.isPresent()) {
                        return Optional.of(Settled.made(wanted, told.get()));
                    }
                }
                others.add(text.get());
            }
        }
        return Optional.empty();
    }

    private static Optional<String> text(DoubleFunction<Scene> change, double value) {
        try {
            return Optional.of(SceneFiles.format(change.apply(value)));
        } catch (IllegalArgumentException refused) {
            return Optional.empty();
        }
    }

    /** A text with a formula wherever it has another number than one that is else the same; empty if nothing differs, or anything else. */
    private static Optional<String> told(String one, String another, String formula) {
        String raw = formula.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
        StringBuilder told = new StringBuilder();
        Matcher a = NUMBER.matcher(one);
        Matcher b = NUMBER.matcher(another);
        int aEnd = 0;
        int bEnd = 0;
        boolean differs = false;
        while (a.find()) {
            if (!b.find() || !one.substring(aEnd, a.start()).equals(another.substring(bEnd, b.start()))) {
                return Optional.empty();
            }
            boolean isSame = a.group().equals(b.group());
            told.append(one, aEnd, a.start()).append(isSame ? a.group() : raw);
            differs |= !isSame;
            aEnd = a.end();
            bEnd = b.end();
        }
        told.append(one.substring(aEnd));
        return differs && !b.find() && one.substring(aEnd).equals(another.substring(bEnd)) ? Optional.of(told.toString()) : Optional.empty();
    }
}
