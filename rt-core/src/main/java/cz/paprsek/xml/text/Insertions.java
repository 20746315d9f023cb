package cz.paprsek.xml.text;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;

/** The elements that are new where they stand: found places for first, written when all that was removed is known. */
final class Insertions {
    private final Source source;
    private final Layout layout;
    private final NewText newText;
    private final List<Insertion> insertions = new ArrayList<>();
    /** Whether something was inserted inside the element at hand, which had no end tag. */
    private boolean isOpened;

    private record Insertion(int at, int to, Supplier<String> text) {}

    Insertions(Source source, Layout layout, NewText newText) {
        this.source = source;
        this.layout = layout;
        this.newText = newText;
    }

    /**
     * Adds what is new in a group of an element.
     *
     * @param elements the group as it stands in the text
     * @param from for each new one, which of the elements it is; −1 for none
     * @param staying of each group, the elements that stay where they are
     * @param scene where the scene begins
     */
    void add(Element parent, String group, List<Element> elements, List<Form> forms, int[] from, Map<String, List<Element>> staying, int scene) {
        int latest = -1;
        for (int j = 0; j < from.length; j++) {
            if (from[j] >= 0) {
                latest = from[j];
            } else if (latest >= 0) {
                after(elements.get(latest), forms.get(j), parent, scene);
            } else if (!staying.getOrDefault(group, List.of()).isEmpty()) {
                before(staying.getOrDefault(group, List.of()).get(0), forms.get(j), parent, scene);
            } else {
                first(parent, group, forms.get(j), staying, scene);
            }
        }
    }

    /** Inserts an element of a group that has no others: where it would stand in a text that is new. */
    private void first(Element parent, String group, Form form, Map<String, List<Element>> staying, int scene) {
        for (int g = Form.GROUPS.indexOf(group) - 1; g >= 0; g--) {
            List<Element> before = staying.getOrDefault(Form.GROUPS.get(g), List.of());
            if (!before.isEmpty()) {
                after(before.get(before.size() - 1), form, parent, scene);
                return;
            }
        }
        staying.values().stream().flatMap(List::stream).min(Comparator.comparingInt(Element::start)).ifPresentOrElse(
                next -> before(next, form, parent, scene), () -> inside(parent, form, scene));
    }

    private void after(Element latest, Form form, Element parent, int scene) {
        boolean isOnLine = layout.beginsLine(latest);
        add(isOnLine ? layout.endWithComments(latest) : latest.end(), isOnLine, layout.indent(latest), form, parent, scene);
    }

    private void before(Element next, Form form, Element parent, int scene) {
        boolean isOnLine = layout.beginsLine(next);
        int at = isOnLine ? layout.lineBreakBefore(layout.startWithComments(next)) : next.start();
        add(at, isOnLine, layout.indent(next), form, parent, scene);
    }

    private void inside(Element parent, Form form, int scene) {
        if (parent.isEmpty() && !isOpened) {
            isOpened = true;
            insertions.add(new Insertion(parent.end() - 2, parent.end(), () -> ">"));
        }
        add(parent.inside(), layout.beginsLine(parent), layout.indent(parent) + layout.unit(), form, parent, scene);
    }

    private void add(int at, boolean isOnLine, String indent, Form form, Element parent, int scene) {
        String before = isOnLine ? layout.lineBreak() + indent : "";
        insertions.add(new Insertion(at, at, () -> before + newText.of(form, source.prefix(parent), isOnLine ? indent : "", scene)));
    }

    /** Gives the element an end tag, by the name that it has now, if it had none and now needs one. */
    void end(Element parent, String name) {
        if (isOpened) {
            isOpened = false;
            String before = layout.beginsLine(parent) ? layout.lineBreak() + layout.indent(parent) : "";
            String tag = "</" + source.prefix(parent) + name + ">";
            insertions.add(new Insertion(parent.end(), parent.end(), () -> before + tag));
        }
    }

    void addTo(Edits edits) {
        insertions.forEach(insertion -> edits.replace(insertion.at(), insertion.to(), insertion.text().get()));
    }
}
