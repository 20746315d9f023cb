package cz.paprsek.image.exr;

/** What numbers a channel is made of; the order of the constants is that of their numbers in a file. */
public enum ExrType {
    /** Whole numbers of 32 bits without a sign. */
    UINT(4),
    HALF(2),
    FLOAT(4);

    private final int bytes;

    ExrType(int bytes) {
        this.bytes = bytes;
    }

    int bytes() {
        return bytes;
    }
}
