package cz.paprsek.formula;

import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * What makes bodies of a scene: a repeat, or the use of a definition. Bodies are told by their numbers: that of the object in the scene, then those of the
 * operands on the way.
 *
 * @param number which of them it is in the file, from 0
 * @param element its name in files
 * @param attributes as they are written, with formulas
 * @param count how many copies there are
 * @param originals the bodies of the first copy
 * @param copies those of all copies, one copy after another
 * @param whole what all copies are operands of; none if they stand in the scene by themselves
 */
public record Maker(int number, String element, Map<String, String> attributes, int count, List<List<Integer>> originals, List<List<Integer>> copies, List<Integer> whole) {
    /** What makes copies. */
    public static final String REPEAT = "repeat";

    public Maker {
        Objects.requireNonNull(element, "element");
        attributes = Map.copyOf(attributes);
        originals = List.copyOf(originals);
        copies = List.copyOf(copies);
        whole = List.copyOf(whole);
    }

    public boolean isRepeat() {
        return element.equals(REPEAT);
    }

    /** What formulas in it call the number of a copy, from 0. */
    public String index() {
        return attributes.getOrDefault("index", "i");
    }

    /** An attribute as it is written; empty if it is not. */
    public String attribute(String name) {
        return attributes.getOrDefault(Objects.requireNonNull(name, "name"), "");
    }
}
