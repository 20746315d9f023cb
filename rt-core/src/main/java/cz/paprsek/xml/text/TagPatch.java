package cz.paprsek.xml.text;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Changes the name and the attributes of an element, each where it stands. */
final class TagPatch {
    private final Source source;
    private final Edits edits;

    TagPatch(Source source, Edits edits) {
        this.source = source;
        this.edits = edits;
    }

    void patch(Element element, Form.Body old, Form.Body now) {
        if (!old.name().equals(now.name())) {
            edits.replace(element.nameFrom(), element.nameTo(), now.name());
            if (!element.isEmpty()) {
                int from = element.insideTo() + 2 + element.prefixLength();
                edits.replace(from, from + element.name().length(), now.name());
            }
        }
        if (!old.attributes().equals(now.attributes())) {
            attributes(element, old.attributes(), now.attributes());
        }
    }

    private void attributes(Element element, Map<String, String> old, Map<String, String> now) {
        List<Source.Attribute> written = source.attributes(element);
        Map<String, Source.Attribute> places = new HashMap<>();
        int before = element.nameTo();
        for (Source.Attribute attribute : written) {
            places.put(attribute.name(), attribute);
            if (old.containsKey(attribute.name()) && !now.containsKey(attribute.name())) {
                edits.remove(before, attribute.end());
            }
            before = attribute.end();
        }
        // One attribute a line, if they are written like that.
        String blank = written.size() < 2 ? " " : source.text(written.get(0).end(), written.get(1).start());
        int latest = element.nameTo();
        for (Map.Entry<String, String> attribute : now.entrySet()) {
            Source.Attribute place = places.get(attribute.getKey());
            boolean isChanged = !attribute.getValue().equals(old.get(attribute.getKey()));
            if (place == null && isChanged) {
                edits.insert(latest, blank + attribute.getKey() + "=\"" + attribute.getValue() + "\"");
            } else if (place != null && isChanged) {
                boolean isDouble = source.has("\"", place.valueTo());
                edits.replace(place.valueFrom(), place.valueTo(), isDouble ? attribute.getValue() : attribute.getValue().replace("'", "&apos;"));
            }
            latest = place == null ? latest : place.end();
        }
    }
}
