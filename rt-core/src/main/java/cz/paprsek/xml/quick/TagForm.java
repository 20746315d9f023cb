package cz.paprsek.xml.quick;

import cz.paprsek.xml.format.SceneFormat;
import java.util.List;
import java.util.stream.Stream;

/** The attributes that a start tag may have, at most 64, and reading them. */
final class TagForm {
    private static final byte[] NAMESPACE_ATTRIBUTE = Slot.ascii("xmlns");

    private final Slot[] slots;
    private final Object[] standard;
    /** A bit for each that must be there. */
    private final long required;

    TagForm(List<Slot> first, List<Slot> then) {
        slots = Stream.concat(first.stream(), then.stream()).toArray(Slot[]::new);
        standard = Stream.of(slots).map(Slot::otherwise).toArray();
        long needed = 0;
        for (int i = 0; i < slots.length; i++) {
            needed |= slots[i].isRequired() ? 1L << i : 0;
        }
        required = needed;
    }

    /** The values, given or not, in the order of the attributes here. */
    Object[] read(Markup markup, double[] room) {
        return read(markup, room, false);
    }

    /** As {@link #read}, of the root of a file, which says the namespace. */
    Object[] readRoot(Markup markup, double[] room) {
        return read(markup, room, true);
    }

    private Object[] read(Markup markup, double[] room, boolean isRoot) {
        Object[] values = standard.clone();
        long had = 0;
        boolean hasNamespace = !isRoot;
        while (markup.nextAttribute()) {
            int number = number(markup);
            if (number < 0) {
                Unusual.unless(!hasNamespace && markup.isNamed(NAMESPACE_ATTRIBUTE) && markup.value().equals(SceneFormat.NAMESPACE));
                hasNamespace = true;
            } else {
                Unusual.unless((had & (1L << number)) == 0);
                had |= 1L << number;
                values[number] = slots[number].form().read(markup, room);
            }
        }
        Unusual.unless(hasNamespace && (required & ~had) == 0);
        return values;
    }

    private int number(Markup markup) {
        for (int i = 0; i < slots.length; i++) {
            if (slots[i].name().isAtHand(markup)) {
                return i;
            }
        }
        return -1;
    }
}
