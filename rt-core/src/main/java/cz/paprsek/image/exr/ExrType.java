package cz.paprsek.image.exr;

import java.util.Arrays;
import java.util.Optional;

/** What numbers a channel is made of. */
public enum ExrType {
    /** Whole numbers of 32 bits without a sign. */
    UINT(0, 4),
    HALF(1, 2),
    FLOAT(2, 4);

    private final int number;
    private final int bytes;

    ExrType(int number, int bytes) {
        this.number = number;
        this.bytes = bytes;
    }

    /** The type that a file means by a number. */
    static Optional<ExrType> of(int number) {
        return Arrays.stream(values()).filter(type -> type.number == number).findFirst();
    }

    int number() {
        return number;
    }

    int bytes() {
        return bytes;
    }
}
