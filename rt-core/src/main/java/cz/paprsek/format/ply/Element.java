package cz.paprsek.format.ply;

import java.util.ArrayList;
import java.util.List;

/** So many things of a kind, each with the same properties. */
record Element(String name, long count, List<Property> properties) {
    Element(String name, long count) {
        this(name, count, new ArrayList<>());
    }

    /** The number of the property that has one of these names, or −1. */
    int indexOf(String... names) {
        for (int i = 0; i < properties.size(); i++) {
            for (String name : names) {
                if (properties.get(i).name().equals(name)) {
                    return i;
                }
            }
        }
        return -1;
    }

    /** How many bytes one of it takes at least. */
    int leastBytes() {
        return properties.stream().mapToInt(Property::leastBytes).sum();
    }
}
