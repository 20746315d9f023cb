package cz.paprsek.xml.text;

/**
 * Where an element stands in a text; all places are in bytes, and each "to" is behind the last.
 *
 * @param name without its prefix
 * @param start where its {@code <} stands
 * @param nameFrom where the name begins, behind the prefix
 * @param inside behind its start tag
 * @param insideTo where its end tag begins; as {@code end} if it has none
 */
public record Element(String name, int start, int nameFrom, int inside, int insideTo, int end) {

    /** Whether it has no end tag. */
    public boolean isEmpty() {
        return inside == end;
    }

    int nameTo() {
        return nameFrom + name.length();
    }

    /** Length of the prefix, its colon included. */
    int prefixLength() {
        return nameFrom - start - 1;
    }
}
