package cz.paprsek.cli.shard;

import java.io.IOException;

/**
 * The frames of a film that are rendered, from one to another.
 *
 * @param first from 1; 0 of a picture that is no film
 */
public record Span(int first, int last) {
    private static final int MOST = 9_999_999;

    /** A picture that does not move, whose only frame is 0. */
    public static final Span STILL = new Span(0, 0);

    /** @throws IllegalArgumentException if there are no such frames */
    public Span {
        if (first < 0 || last < first || (first == 0 && last > 0) || last > MOST) {
            throw new IllegalArgumentException("there are no frames from " + first + " to " + last);
        }
    }

    static Span read(Fields fields) throws IOException {
        int[] numbers = fields.numbers("frames", 2);
        return new Span(numbers[0], numbers[1]);
    }

    void put(StringBuilder text) {
        Fields.put(text, "frames", first + " " + last);
    }

    /** The frames of both, and those between. */
    Span with(Span other) {
        return isStill() ? other : other.isStill() ? this : new Span(Math.min(first, other.first), Math.max(last, other.last));
    }

    boolean has(int frame) {
        return frame >= first && frame <= last;
    }

    /** Whether it is a picture that does not move. */
    public boolean isStill() {
        return first == 0;
    }

    public int count() {
        return last - first + 1;
    }
}
