package cz.paprsek.query;

import java.util.List;

/** What the values of a column are. */
public enum Type {
    NUMBER("a number"),
    TEXT("text"),
    /** Three numbers, x y z. */
    VECTOR("three numbers"),
    /** Three numbers 0–255, red green blue. */
    COLOR("a color");

    private final String words;

    Type(String words) {
        this.words = words;
    }

    /** The type in words, for a sentence: {@code a number}. */
    public String words() {
        return words;
    }

    /** The names of the numbers that such a value has in it; none if it is no more than one. */
    public List<String> parts() {
        return switch (this) {
            case NUMBER, TEXT -> List.of();
            case VECTOR -> List.of("x", "y", "z");
            case COLOR -> List.of("red", "green", "blue");
        };
    }
}
