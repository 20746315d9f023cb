package cz.paprsek.shape.check;

import cz.paprsek.math.Vec3;
import cz.paprsek.text.Numbers;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/** What was tried, how often, how often it went wrong, and where first. */
final class Problems {
    /** What a shape promises, and the share of trials in which it may go wrong: by rounding, at an edge or where a line just touches. */
    enum Promise {
        MET("is met by hardly any of the lines through its bounds, which must be much too large", 0.98),
        BOUNDS("is crossed outside its bounds", 0),
        LINE("is crossed by a line at other places if that starts elsewhere or runs the other way; all crossings of the whole line must be told", 0.001),
        NEAREST("is not met at the first of its crossings", 0),
        LENGTH("has a normal that is no direction", 0),
        SIDE("has a normal that looks inwards, or is crossed at something else than entering and leaving in turn", 0.001),
        NORMAL("has a normal that is not at right angles to it", 0.02),
        INSIDE("holds a point seen one way and not another", 0.001),
        LEAVING("is not left where a line starts inwards from its surface, or left where it starts outwards", 0.001),
        MAP("has u, v or a tangent that are no numbers, or a tangent that does not lie along it", 0);

        private final String fault;
        private final double allowed;

        Promise(String fault, double allowed) {
            this.fault = fault;
            this.allowed = allowed;
        }
    }

    private final Map<Promise, int[]> counts = new EnumMap<>(Promise.class);
    private final Map<Promise, String> examples = new EnumMap<>(Promise.class);
    private String fatal = "";

    /** Counts a trial. */
    void expect(Promise promise, boolean kept, Vec3 where) {
        int[] count = counts.computeIfAbsent(promise, p -> new int[2]);
        count[0]++;
        if (!kept) {
            count[1]++;
            examples.putIfAbsent(promise, Numbers.text(where));
        }
    }

    /** Notes what the shape itself threw, or what it said that nothing can be made of. */
    void threw(RuntimeException thrown) {
        fatal = String.valueOf(thrown.getMessage() == null ? thrown : thrown.getMessage());
    }

    boolean isFatal() {
        return !fatal.isEmpty();
    }

    List<String> sentences() {
        List<String> sentences = new ArrayList<>();
        if (isFatal()) {
            sentences.add(fatal);
        }
        counts.forEach((promise, count) -> {
            if (count[1] > promise.allowed * count[0]) {
                sentences.add("it " + promise.fault + ": " + count[1] + " of " + count[0] + " times, first at " + examples.get(promise));
            }
        });
        return List.copyOf(sentences);
    }
}
