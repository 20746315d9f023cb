package cz.paprsek.format.ply;

import java.util.Arrays;
import java.util.Optional;

/**
 * One property of an element.
 *
 * @param count the kind of number in front of a list; empty for a single number
 */
record Property(String name, Kind kind, Optional<Kind> count) {

    /** A kind of number, with its two names. */
    enum Kind {
        CHAR(1, "char", "int8"), UCHAR(1, "uchar", "uint8"), SHORT(2, "short", "int16"), USHORT(2, "ushort", "uint16"),
        INT(4, "int", "int32"), UINT(4, "uint", "uint32"), FLOAT(4, "float", "float32"), DOUBLE(8, "double", "float64");

        final int bytes;
        private final String name;
        private final String other;

        Kind(int bytes, String name, String other) {
            this.bytes = bytes;
            this.name = name;
            this.other = other;
        }

        boolean isFraction() {
            return this == FLOAT || this == DOUBLE;
        }

        static Optional<Kind> of(String name) {
            return Arrays.stream(values()).filter(kind -> kind.name.equals(name) || kind.other.equals(name)).findFirst();
        }
    }

    boolean isList() {
        return count.isPresent();
    }

    /** How many bytes it takes at least. */
    int leastBytes() {
        return count.map(kind -> kind.bytes).orElse(kind.bytes);
    }
}
