package cz.paprsek.xml;

import cz.paprsek.formula.Formula;
import cz.paprsek.formula.Maker;
import cz.paprsek.math.Require;
import cz.paprsek.scene.Scene;
import cz.paprsek.text.Numbers;
import cz.paprsek.xml.recipe.Script;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
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

    /** Two texts of a scene that differ only in some numbers, in all of which one of them has a value. */
    private record Place(String one, String another, double value) {
        /** With something else in the place of these numbers. */
        String told(String instead) {
            return Formulated.told(one, another, instead).orElseThrow();
        }
    }

    /** Of what is repeated, copies follow the first; with the number of the copy in the formula, each has its own. */
    static Scene of(Scene scene, DoubleFunction<Scene> change, String formula) {
        boolean repeats = scene.recipe().text().contains("<repeat");
        Set<String> numbers = repeats ? numbers(scene, formula) : Set.of();
        Optional<Scene> ofEach = numbers.isEmpty() ? Optional.empty() : ofEach(scene, change, formula, numbers);
        if (ofEach.isPresent()) {
            return ofEach.get();
        }
        double value = (scene.recipe().isNone() ? Script.valueOfPlain(formula) : Settled.script(scene.recipe()).value(formula, Set.of())) + 0.0;
        Optional<Scene> followed = repeats ? with(number -> Settled.following(change.apply(number)), value, formula) : Optional.empty();
        return followed.or(() -> with(change, value, formula)).orElseThrow(() -> new IllegalArgumentException("no formula can stand here"));
    }

    /** The names in a formula that number copies somewhere in the scene. */
    private static Set<String> numbers(Scene scene, String formula) {
        Set<String> names = new LinkedHashSet<>(Formula.of(formula).names());
        names.retainAll(Settled.makers(scene.recipe()).stream().filter(Maker::isRepeat).map(Maker::index).toList());
        return names;
    }

    /**
     * With a formula that has the numbers of copies. What the change changes is that of the first copy.
     *
     * @return empty if nothing there is repeated, or not by these numbers
     */
    private static Optional<Scene> ofEach(Scene scene, DoubleFunction<Scene> change, String formula, Set<String> numbers) {
        Optional<Place> place = place(number -> Settled.following(change.apply(number), true), 1);
        if (place.isEmpty() || !isScene(scene, place.get().told("{" + place.get().value() + "+0*(" + String.join("+", numbers) + ")}"))) {
            return Optional.empty();
        }
        double first = Settled.script(scene.recipe()).value(formula, numbers) + 0.0;
        // Here it is told whether the first copy can have it at all.
        Objects.requireNonNull(change.apply(first));
        Require.that(place.get().told(Numbers.text(place.get().value())).equals(place.get().one()), "no formula can stand here");
        return Optional.of(Settled.like(scene, Settled.remade(scene, place.get().told("{" + formula + "}"))));
    }

    private static boolean isScene(Scene scene, String text) {
        try {
            Settled.remade(scene, text);
            return true;
        } catch (IllegalArgumentException without) {
            return false;
        }
    }

    /** Empty if another number changes nothing, or more than numbers. */
    private static Optional<Scene> with(DoubleFunction<Scene> change, double value, String formula) {
        Scene wanted = change.apply(value);
        return place(change, value).map(found -> Settled.made(wanted, found.told("{" + formula + "}")));
    }

    private static Optional<Place> place(DoubleFunction<Scene> change, double value) {
        List<Place> others = new ArrayList<>();
        for (double[] other : OTHERS) {
            double number = value * other[1] + other[0];
            Optional<String> text = text(change, number);
            if (text.isPresent()) {
                Require.that(text.get().length() <= Making.LONGEST, "a scene as large as this cannot have formulas");
                for (Place one : others) {
                    if (told(one.another(), text.get(), "").isPresent()) {
                        return Optional.of(new Place(one.another(), text.get(), one.value()));
                    }
                }
                others.add(new Place("", text.get(), number));
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
