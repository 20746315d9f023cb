package cz.paprsek.render.explain;

import cz.paprsek.math.Require;
import java.util.List;
import java.util.stream.Stream;

/**
 * Which surface of a scene: an object, and within a CSG body the operand, its operand, and so on.
 *
 * @param numbers the object's number in the scene, then that of each operand among its siblings, all from 0
 * @param labels for each of them its kind, and its name or number
 */
public record SurfacePath(List<Integer> numbers, List<String> labels) {
    public SurfacePath {
        numbers = List.copyOf(numbers);
        labels = List.copyOf(labels);
        Require.that(!numbers.isEmpty() && numbers.size() == labels.size(), "a path needs as many labels as numbers, and at least one");
    }

    /** The path to an operand of what this path leads to. */
    public SurfacePath to(int number, String label) {
        return new SurfacePath(longer(numbers, number), longer(labels, label));
    }

    /** The object's number in the scene, from 0. */
    public int object() {
        return numbers.get(0);
    }

    /** The object. */
    public String objectLabel() {
        return labels.get(0);
    }

    /** The whole path, such as {@code difference "bowl" › sphere "hollow"}. */
    @Override
    public String toString() {
        return String.join(" › ", labels);
    }

    private static <T> List<T> longer(List<T> list, T item) {
        return Stream.concat(list.stream(), Stream.of(item)).toList();
    }
}
