package cz.paprsek.spark;

import cz.paprsek.cli.output.Writing;
import cz.paprsek.cli.shard.Piecework;
import cz.paprsek.image.ImageFormat;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * What the user said.
 *
 * @param output where pictures go, in a file system that Hadoop knows
 * @param side of tiles, in pixels, if the user knows better
 * @param ending that of the pictures' format
 * @param writing how pictures are written
 * @param render all other words, for {@code render}
 */
record Words(String output, Optional<Integer> side, String ending, Writing writing, List<String> render) {
    private static final String OUTPUT = "--output";
    private static final String SIDE = "--side";
    private static final String FORMAT = "--format";
    private static final String BITS = "--bits";
    private static final String UNCOMPRESSED = "--uncompressed";
    private static final String ASSETS = "--assets";
    /** Each is followed by a value. */
    private static final Map<String, String> OWN = Map.of("-o", OUTPUT, OUTPUT, OUTPUT, SIDE, SIDE, FORMAT, FORMAT, BITS, BITS);

    Words {
        render = List.copyOf(render);
    }

    /** @throws IllegalArgumentException with a sentence for the user */
    static Words of(List<String> all) {
        Map<String, String> own = new HashMap<>();
        boolean uncompressed = false;
        List<String> render = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            String word = all.get(i);
            int equals = word.startsWith("--") ? word.indexOf('=') : -1;
            String name = OWN.getOrDefault(equals < 0 ? word : word.substring(0, equals), "");
            if (word.equals(UNCOMPRESSED)) {
                uncompressed = true;
            } else if (name.isEmpty()) {
                render.add(word);
            } else {
                if (equals < 0 && ++i == all.size()) {
                    throw new IllegalArgumentException(word + " wants a value");
                }
                if (own.put(name, equals < 0 ? all.get(i) : word.substring(equals + 1)) != null) {
                    throw new IllegalArgumentException(name + " is said twice");
                }
            }
        }
        String output = own.getOrDefault(OUTPUT, "");
        if (output.isEmpty() || output.equals("-")) {
            throw new IllegalArgumentException("say where the pictures go, such as -o hdfs:///films/flight-{frame}.png; a name that ends in / is a directory");
        }
        Optional<Integer> side = Optional.ofNullable(own.get(SIDE)).map(value -> Piecework.requireSide(number(value, SIDE + " is a number of pixels, a multiple of 32")));
        Optional<Integer> bits = Optional.ofNullable(own.get(BITS)).map(value -> number(value, BITS + " is a number of bits per channel"));
        return new Words(output, side, Objects.requireNonNullElseGet(own.get(FORMAT), () -> ending(output)), new Writing(bits, uncompressed), render);
    }

    private static int number(String value, String otherwise) {
        try {
            return Integer.parseInt(value);
        } catch (NumberFormatException none) {
            throw new IllegalArgumentException(otherwise + ", not " + value, none);
        }
    }

    /** The ending of the output, which says the format of the pictures if nothing else does. */
    private static String ending(String output) {
        String name = output.substring(output.lastIndexOf('/') + 1);
        if (ImageFormat.ofFile(name).isEmpty() && !name.isEmpty()) {
            throw new IllegalArgumentException("cannot tell the format of '" + output + "': let it end in one of " + ImageFormat.all() + ", give --format, or end a directory's name in /");
        }
        return name.isEmpty() ? "png" : name.substring(name.lastIndexOf('.') + 1);
    }

    /**
     * Whether pictures can be written like that, which is known before they are rendered.
     *
     * @throws cz.paprsek.cli.process.WrongUsage if not
     */
    void check() {
        writing.check(ImageFormat.of(ending).stream().toList());
    }

    /** What to say to {@code render}, which must know for which format. */
    List<String> order() {
        List<String> words = new ArrayList<>(render);
        words.addAll(List.of(FORMAT, ending));
        return words;
    }

    /** What to say to {@code merge}. */
    List<String> written() {
        List<String> words = new ArrayList<>(List.of(FORMAT, ending));
        writing.bits().ifPresent(bits -> words.addAll(List.of(BITS, String.valueOf(bits))));
        if (writing.uncompressed()) {
            words.add(UNCOMPRESSED);
        }
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
