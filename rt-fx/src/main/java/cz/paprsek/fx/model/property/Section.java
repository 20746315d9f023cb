package cz.paprsek.fx.model.property;

import java.util.List;

/**
 * Properties shown under one heading.
 *
 * @param title the key of the heading's text
 * @param properties in order
 */
public record Section(String title, List<Property> properties) {
    public Section {
        properties = List.copyOf(properties);
    }
}
