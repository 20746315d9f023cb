package cz.paprsek.format.gltf;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.text.Numbers;
import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A JSON object and where it stands in its document: what it is asked for is there and of the right kind, or a fault says what was expected.
 *
 * @param path as in {@code meshes[3].primitives[0]}; empty for the document
 */
record Tree(String path, Map<String, Object> members) {
    static final Tree NOTHING = new Tree("", Map.of());

    static Tree of(ByteBuffer json) throws FormatFault {
        byte[] text = new byte[json.remaining()];
        json.get(text);
        return new Tree("", object(JsonText.parse(text), "the document"));
    }

    @SuppressWarnings("unchecked") // Maps are made in JsonText alone, with names as keys.
    private static Map<String, Object> object(Object value, String path) throws FormatFault {
        if (!(value instanceof Map)) {
            throw FormatFault.in(path, "this must be an object in { }");
        }
        return (Map<String, Object>) value;
    }

    String at(String name) {
        return path.isEmpty() ? name : path + "." + name;
    }

    FormatFault fault(String sentence) {
        return FormatFault.in(path.isEmpty() ? "the document" : path, sentence);
    }

    FormatFault fault(String name, String sentence) {
        return FormatFault.in(at(name), sentence);
    }

    boolean has(String name) {
        return members.containsKey(name);
    }

    Optional<Tree> child(String name) throws FormatFault {
        Object value = members.get(name);
        return value == null ? Optional.empty() : Optional.of(new Tree(at(name), object(value, at(name))));
    }

    /** An empty one if there is none. */
    Tree childOrNothing(String name) throws FormatFault {
        return child(name).orElse(new Tree(at(name), Map.of()));
    }

    /** An extension by its name. */
    Optional<Tree> extension(String name) throws FormatFault {
        return childOrNothing("extensions").child(name);
    }

    List<?> list(String name) throws FormatFault {
        Object value = members.get(name);
        if (value == null) {
            return List.of();
        }
        if (!(value instanceof List<?> list)) {
            throw fault(name, "this must be a list in [ ]");
        }
        return list;
    }

    int count(String name) throws FormatFault {
        return list(name).size();
    }

    /** The object in a list. */
    Tree item(String name, int index) throws FormatFault {
        List<?> list = list(name);
        if (index < 0 || index >= list.size()) {
            throw fault("there is no " + name + "[" + index + "], but " + list.size() + " of them");
        }
        String where = at(name) + "[" + index + "]";
        return new Tree(where, object(list.get(index), where));
    }

    double number(String name, double otherwise) throws FormatFault {
        Object value = members.get(name);
        if (value == null) {
            return otherwise;
        }
        if (!(value instanceof Double number)) {
            throw fault(name, "this must be a number");
        }
        return number;
    }

    /** A number from low to high. */
    double share(String name, double otherwise, double low, double high) throws FormatFault {
        double value = number(name, otherwise);
        if (!(value >= low && value <= high)) {
            throw fault(name, "this must be a number from " + Numbers.text(low) + " to " + Numbers.text(high) + ", but is " + Numbers.text(value));
        }
        return value;
    }

    /** A whole number from 0 on; −1 if there is none. */
    int index(String name) throws FormatFault {
        return has(name) ? whole(name, 0) : -1;
    }

    int whole(String name, int otherwise) throws FormatFault {
        double value = number(name, otherwise);
        if (!(value >= 0 && value <= Integer.MAX_VALUE && value == Math.rint(value))) {
            throw fault(name, "this must be a whole number from 0 to " + Integer.MAX_VALUE + ", but is " + Numbers.text(value));
        }
        return (int) value;
    }

    int needed(String name) throws FormatFault {
        if (!has(name)) {
            throw fault("here must be " + FormatFault.quoted(name));
        }
        return whole(name, 0);
    }

    String text(String name, String otherwise) throws FormatFault {
        Object value = members.get(name);
        if (value == null) {
            return otherwise;
        }
        if (!(value instanceof String text)) {
            throw fault(name, "this must be a text in quotes");
        }
        return text;
    }

    boolean flag(String name) throws FormatFault {
        Object value = members.get(name);
        if (value != null && !(value instanceof Boolean)) {
            throw fault(name, "this must be true or false");
        }
        return Boolean.TRUE.equals(value);
    }

    /** As many numbers as there are usually. */
    double[] numbers(String name, double... otherwise) throws FormatFault {
        List<?> list = list(name);
        if (!has(name)) {
            return otherwise;
        }
        if (list.size() != otherwise.length) {
            throw fault(name, "these must be " + otherwise.length + " numbers, but are " + list.size());
        }
        double[] numbers = new double[otherwise.length];
        for (int i = 0; i < numbers.length; i++) {
            if (!(list.get(i) instanceof Double number)) {
                throw fault(name, "these must be numbers");
            }
            numbers[i] = number;
        }
        return numbers;
    }

    /** A list of numbers, of any length. */
    double[] anyNumbers(String name) throws FormatFault {
        return numbers(name, new double[list(name).size()]);
    }

    /** A list of whole numbers, each below a limit. */
    int[] indexes(String name, int limit) throws FormatFault {
        List<?> list = list(name);
        int[] indexes = new int[list.size()];
        for (int i = 0; i < indexes.length; i++) {
            if (!(list.get(i) instanceof Double number) || !(number >= 0 && number < limit && number == Math.rint(number))) {
                throw fault(name, limit == 0 ? "these are numbers of things of which there are none" : "these must be whole numbers from 0 to " + (limit - 1));
            }
            indexes[i] = number.intValue();
        }
        return indexes;
    }

    /** The names of the members, in their order. */
    List<String> names() {
        return List.copyOf(new LinkedHashMap<>(members).keySet());
    }
}
