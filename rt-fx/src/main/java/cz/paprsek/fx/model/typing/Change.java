package cz.paprsek.fx.model.typing;

import java.util.Optional;

/**
 * What makes one text of another: a piece of it is replaced.
 *
 * @param from where that begins
 * @param to behind its end
 * @param text what takes its place
 */
public record Change(int from, int to, String text) {

    /** The smallest there is. */
    public static Change between(String before, String after) {
        int most = Math.min(before.length(), after.length());
        int from = 0;
        while (from < most && before.charAt(from) == after.charAt(from)) {
            from++;
        }
        int behind = 0;
        while (behind < most - from && before.charAt(before.length() - 1 - behind) == after.charAt(after.length() - 1 - behind)) {
            behind++;
        }
        return new Change(from, before.length() - behind, after.substring(from, after.length() - behind));
    }

    public boolean isNone() {
        return from == to && text.isEmpty();
    }

    public String applied(String before) {
        return before.substring(0, from) + text + before.substring(to);
    }

    /** How much longer it makes a text. */
    private int growth() {
        return text.length() - (to - from);
    }

    /** Where a place of the text before is in that after; empty if it is within what is replaced. */
    public Optional<Integer> after(int place) {
        return place <= from ? Optional.of(place) : place >= to ? Optional.of(place + growth()) : Optional.empty();
    }

    /** Where a place of the text after was in that before; empty if it is within what is new. */
    public Optional<Integer> before(int place) {
        return place <= from ? Optional.of(place) : place >= from + text.length() ? Optional.of(place - growth()) : Optional.empty();
    }

    /** The same change of a text that another has changed already, elsewhere; empty if both are about the same place. */
    public Optional<Change> behind(Change other) {
        if (to < other.from) {
            return Optional.of(this);
        }
        return from > other.to ? Optional.of(new Change(from + other.growth(), to + other.growth(), text)) : Optional.empty();
    }
}
