package cz.paprsek.shape.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** To which parts triangles belong, while they are added. Has no numbers as long as there is one part. */
final class GrowingParts {
    private final List<String> names = new ArrayList<>();
    private final Map<String, Integer> known = new HashMap<>();
    private int part;
    private int[] numbers = {};

    /** The triangles that come from now on belong to the part of that name; so many have come. */
    void begin(String name, int triangles) {
        part = known.computeIfAbsent(name, key -> {
            names.add(key);
            return names.size() - 1;
        });
        if (part > 0 && numbers.length == 0) {
            numbers = new int[Math.max(64, triangles)];
        }
    }

    void add(int triangle) {
        if (names.isEmpty()) {
            begin("", 0);
        }
        if (numbers.length > 0) {
            if (triangle >= numbers.length) {
                numbers = Arrays.copyOf(numbers, Growing.from(numbers.length));
            }
            numbers[triangle] = part;
        }
    }

    List<String> names() {
        return names.isEmpty() ? List.of("") : names;
    }

    int[] numbers(int triangles) {
        return Growing.cut(numbers, triangles);
    }
}
