package cz.paprsek.shape.font;

/** A table of a font: numbers of 1, 2 and 4 bytes, the most significant first, by their place in the table. Whoever reads beyond its end is told where. */
final class Table {
    private final byte[] file;
    private final int from;
    private final int length;
    private final String name;

    /** @throws IllegalArgumentException if it does not lie within the file */
    Table(byte[] file, long from, long length, String name) {
        if (from > file.length || length > file.length - from) {
            throw new IllegalArgumentException("the table " + name + " should have " + length + " bytes from byte " + from + " on, but the font ends at byte " + file.length);
        }
        this.file = file;
        this.from = (int) from;
        this.length = (int) length;
        this.name = name;
    }

    /** The rest from a place on. */
    Table at(long place) {
        return new Table(file, check(place, 0), length - place, name);
    }

    int unsigned8(long place) {
        return file[check(place, 1)] & 0xff;
    }

    int unsigned16(long place) {
        int at = check(place, 2);
        return (file[at] & 0xff) << 8 | (file[at + 1] & 0xff);
    }

    int signed16(long place) {
        return (short) unsigned16(place);
    }

    long unsigned32(long place) {
        return (long) unsigned16(place) << 16 | unsigned16(place + 2);
    }

    private int check(long place, int bytes) {
        if (place < 0 || place + bytes > length) {
            throw new IllegalArgumentException("the table " + name + " ends at byte " + (from + length) + " of the font, but should go on to byte " + (from + place + bytes));
        }
        return (int) (from + place);
    }

    /** Something that is not as it should be. */
    IllegalArgumentException refused(long place, String expected, long found) {
        return new IllegalArgumentException("at byte " + (from + place) + ", in the table " + name + ", " + expected + " must stand, but " + found + " was found");
    }
}
