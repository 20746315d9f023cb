package cz.paprsek.format.model;

import java.util.Objects;

/**
 * What the numbers of a file mean, which most formats leave to custom.
 *
 * @param unit the length of 1: {@code mm}, {@code m}; empty if nobody says
 * @param isZUp whether z goes up in it, rather than y
 */
public record Convention(String unit, boolean isZUp) {
    public Convention {
        Objects.requireNonNull(unit, "unit");
    }
}
