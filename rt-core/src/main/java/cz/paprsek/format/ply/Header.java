package cz.paprsek.format.ply;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Transcoded;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * What the head of a file says of the rest.
 *
 * @param isLittle whether the low bytes come first; empty for text
 * @param lines how many lines the head has
 * @param bytes how many bytes the head has
 */
record Header(Optional<Boolean> isLittle, List<Element> elements, long lines, long bytes) {
    private static final int LONGEST = 100_000;
    private static final int MOST_PROPERTIES = 1000;

    /** Reads the head, and not a byte more. */
    static Header read(InputStream input) throws IOException {
        return new Reading(input).read();
    }

    private static final class Reading {
        private final InputStream input;
        private final List<Element> elements = new ArrayList<>();
        private Optional<Boolean> isLittle = Optional.empty();
        private boolean hasFormat;
        /** Whether lines end with a return alone, or with two bytes; as the first one does. */
        private boolean isReturnAlone;
        private int properties;
        private long lines;
        private long bytes;

        Reading(InputStream input) {
            this.input = input;
        }

        Header read() throws IOException {
            if (!firstLine().equals("ply")) {
                throw FormatFault.line(1, "a PLY file begins with the line \"ply\"");
            }
            for (String line = line(); !line.equals("end_header"); line = line()) {
                understand(line.split("[ \t]+"));
            }
            if (!hasFormat) {
                throw fault("before the end of the head must be a line \"format\"");
            }
            return new Header(isLittle, elements, lines, bytes);
        }

        private String firstLine() throws IOException {
            StringBuilder line = new StringBuilder();
            lines++;
            int b = next();
            for (; b != '\n' && b != '\r' && line.length() < 4; b = next()) {
                line.append((char) b);
            }
            if (b == '\r') {
                input.mark(1);
                if (input.read() == '\n') {
                    bytes++;
                } else {
                    isReturnAlone = true;
                    input.reset();
                }
            }
            return line.toString();
        }

        private String line() throws IOException {
            int end = isReturnAlone ? '\r' : '\n';
            byte[] text = new byte[128];
            int length = 0;
            lines++;
            for (int b = next(); b != end; b = next()) {
                if (length == text.length) {
                    text = Arrays.copyOf(text, 2 * length);
                }
                if (bytes > LONGEST) {
                    throw fault("the head of this file is longer than " + LONGEST + " bytes");
                }
                text[length++] = (byte) b;
            }
            return Transcoded.decoded(text, 0, length).strip();
        }

        private int next() throws IOException {
            int b = input.read();
            bytes++;
            if (b < 0) {
                throw fault("the file ends within its head");
            }
            return b;
        }

        private void understand(String[] words) throws IOException {
            switch (words[0]) {
                case "format" -> format(words);
                case "element" -> {
                    require(words.length == 3, "an element has a name and a count");
                    elements.add(new Element(words[1], count(words[2])));
                }
                case "property" -> property(words);
                case "comment", "obj_info", "" -> { }
                default -> throw fault("here must be one of format, element, property, comment, end_header, but is " + FormatFault.quoted(words[0]));
            }
        }

        private void format(String[] words) throws IOException {
            String name = words.length > 1 ? words[1] : "";
            require(name.equals("ascii") || name.equals("binary_little_endian") || name.equals("binary_big_endian"),
                    "the format must be ascii, binary_little_endian or binary_big_endian, but is " + FormatFault.quoted(name));
            isLittle = name.equals("ascii") ? Optional.empty() : Optional.of(name.equals("binary_little_endian"));
            hasFormat = true;
        }

        private void property(String[] words) throws IOException {
            require(!elements.isEmpty(), "a property must come after its element");
            require(++properties <= MOST_PROPERTIES, "there are more than " + MOST_PROPERTIES + " properties");
            boolean isList = words.length > 1 && words[1].equals("list");
            require(words.length == (isList ? 5 : 3), "a property has a type and a name, and a list two types");
            Optional<Property.Kind> count = isList ? Optional.of(kind(words[2])) : Optional.empty();
            require(count.isEmpty() || !count.get().isFraction(), "the length of a list must be a whole number");
            elements.get(elements.size() - 1).properties().add(new Property(words[words.length - 1], kind(words[isList ? 3 : 1]), count));
        }

        private Property.Kind kind(String name) throws IOException {
            return Property.Kind.of(name).orElseThrow(() -> fault(FormatFault.quoted(name) + " is no type of numbers"));
        }

        private long count(String word) throws IOException {
            require(word.matches("\\d{1,18}"), "the count of an element must be a whole number, but is " + FormatFault.quoted(word));
            return Long.parseLong(word);
        }

        private void require(boolean condition, String sentence) throws FormatFault {
            if (!condition) {
                throw fault(sentence);
            }
        }

        private FormatFault fault(String sentence) {
            return FormatFault.line(lines, sentence);
        }
    }
}
