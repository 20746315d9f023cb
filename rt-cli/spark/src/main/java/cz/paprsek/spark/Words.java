package cz.paprsek.spark;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What the user said.
 *
 * @param output where pictures go, in a file system that Hadoop knows
 * @param side of tiles, in pixels, if the user knows better
 * @param written how pictures are written: words for {@code merge}
 * @param render all other words, for {@code render}
 */
record Words(String output, Optional<Integer> side, List<String> written, List<String> render) {
    private static final String OUTPUT = "--output";
    private static final String SIDE = "--side";
    private static final String FORMAT = "--format";
    private static final String UNCOMPRESSED = "--uncompressed";
    private static final String ASSETS = "--assets";
    /** Each is followed by a value. */
    private static final Map<String, String> OWN = Map.of("-o", OUTPUT, OUTPUT, OUTPUT, SIDE, SIDE, FORMAT, FORMAT, "--bits", "--bits");

    Words {
        written = List.copyOf(written);
        render = List.copyOf(render);
    }

    /** @throws IllegalArgumentException with a sentence for the user */
    static Words of(List<String> all) {
        Optional<String> output = Optional.empty();
        Optional<Integer> side = Optional.empty();
        List<String> written = new ArrayList<>();
        List<String> render = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            String word = all.get(i);
            int equals = word.startsWith("--") ? word.indexOf('=') : -1;
            String name = OWN.getOrDefault(equals < 0 ? word : word.substring(0, equals), "");
            if (word.equals(UNCOMPRESSED)) {
                written.add(word);
            } else if (name.isEmpty()) {
                render.add(word);
            } else {
                if (equals < 0 && ++i == all.size()) {
                    throw new IllegalArgumentException(word + " wants a value");
                }
                String value = equals < 0 ? all.get(i) : word.substring(equals + 1);
                switch (name) {
                    case OUTPUT -> output = Optional.of(value);
                    case SIDE -> side = Optional.of(pixels(value));
                    default -> written.addAll(List.of(name, value));
                }
            }
        }
        if (output.isEmpty() || output.get().equals("-") || output.get().isEmpty()) {
            throw new IllegalArgumentException("say where the pictures go, such as -o hdfs:///films/flight-{frame}.png; a name that ends in / is a directory");
        }
        return new Words(output.get(), side, written, render);
    }

    private static int pixels(String value) {
        try {
            return Integer.parseInt(value);
        } catch (NumberFormatException none) {
            throw new IllegalArgumentException(SIDE + " is a number of pixels, a multiple of 32, not " + value, none);
        }
    }

    /** The ending that says the format of the pictures. */
    String ending() {
        int format = written.indexOf(FORMAT);
        String name = output.substring(output.lastIndexOf('/') + 1);
        return format >= 0 ? written.get(format + 1) : name.contains(".") ? name.substring(name.lastIndexOf('.') + 1) : "png";
    }

    /** What to say to {@code render}, which must know for which format. */
    List<String> order() {
        List<String> words = new ArrayList<>(render);
        words.addAll(List.of(FORMAT, ending()));
        return words;
    }

    /** The words of an order for a copy of the scene that has all its files beside it. */
    static List<String> elsewhere(List<String> order, String scene, String copy) {
        List<String> words = new ArrayList<>();
        for (int i = 0; i < order.size(); i++) {
            String word = order.get(i);
            if (word.equals(ASSETS)) {
                i++;
            } else if (!word.startsWith(ASSETS + "=")) {
                words.add(word.equals(scene) ? copy : word);
            }
        }
        return words;
    }
}
