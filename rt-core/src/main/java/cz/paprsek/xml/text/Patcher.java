package cz.paprsek.xml.text;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Finds what has to be replaced in a text, so that it says what something has become. */
final class Patcher {
    private static final String CDATA = "<![CDATA[";

    private final Source source;
    private final Layout layout;
    private final int deepest;
    private final Edits edits = new Edits();
    private final Removed removed = new Removed();
    private final NewText newText;
    private final Insertions insertions;
    private final List<Kept> kept = new ArrayList<>();
    /** Where the scene begins that is at hand. */
    private int scene;

    /** A scene that stays as it is, and where it stands. */
    record Kept(Form form, Element element) {}

    /** @param deepest what is changed at this depth is written anew as a whole; the root is at 0 */
    Patcher(Source source, Layout layout, int deepest) {
        this.source = source;
        this.layout = layout;
        this.deepest = deepest;
        newText = new NewText(layout, removed, this::moved);
        insertions = new Insertions(source, layout, newText);
    }

    Edits edits() {
        return edits;
    }

    /** The scenes of a database that stay as they are. */
    List<Kept> kept() {
        return kept;
    }

    void patchRoot(Form old, Form now) {
        patch(source.root(), old, now, 0);
        finish();
    }

    void patchElement(Element element, Form old, Form now) {
        if (!old.body().equals(now.body())) {
            patch(element, old, now, 1);
            finish();
        }
    }

    /** An element with the comments that belong to it, which stands elsewhere now and has perhaps been changed. */
    private String moved(Element element, Form old, Form now) {
        Patcher inner = new Patcher(source, layout, deepest);
        inner.patchElement(element, old, now);
        byte[] text = inner.edits.applied(source.bytes(), layout.startWithComments(element), layout.endWithComments(element));
        return new String(text, StandardCharsets.UTF_8);
    }

    /** What is new may be what was removed elsewhere, so that all of that must be known. */
    private void finish() {
        insertions.addTo(edits);
        removed.pieces().forEach(this::remove);
    }

    private void patch(Element element, Form old, Form now, int depth) {
        if (now.excerpt().isPresent()) {
            String text = now.excerpt().get().within(source.prefix(element), layout.indent(element), layout.lineBreak());
            edits.replace(Excerpt.hasCommentsBefore(text) ? layout.startWithComments(element) : element.start(),
                    Excerpt.hasCommentsBehind(text) ? layout.endWithComments(element) : element.end(), text);
            return;
        }
        Map<String, List<Element>> parts = new HashMap<>();
        source.children(element).forEach(child -> parts.computeIfAbsent(Form.group(child.name()), group -> new ArrayList<>()).add(child));
        scene = element.name().equals("scene") ? element.start() : scene;
        if (depth >= deepest || !fits(parts, old.body())) {
            edits.replace(element.start(), element.end(), newText.of(now, source.prefix(element), layout.indent(element), scene));
            return;
        }
        new TagPatch(source, edits).patch(element, old.body(), now.body());
        if (!old.body().content().equals(now.body().content())) {
            content(element, now.body().content().replace("\n", layout.lineBreak()));
        }
        children(element, parts, old.body(), now.body(), depth);
    }

    /** Whether the text has the elements that it should; one may be written though it says nothing, as {@code <render/>}. */
    private static boolean fits(Map<String, List<Element>> parts, Form.Body old) {
        Map<String, List<Form>> forms = grouped(old);
        return parts.keySet().containsAll(forms.keySet()) && parts.entrySet().stream().allMatch(part -> {
            int count = forms.getOrDefault(part.getKey(), List.of()).size();
            return part.getValue().size() == count || (part.getValue().size() == 1 && count == 0);
        });
    }

    private void content(Element element, String text) {
        if (element.isEmpty()) {
            String end = "</" + source.prefix(element) + element.name() + ">";
            edits.replace(element.end() - 2, element.end(), ">" + text + end);
        } else if (source.has(CDATA, element.inside()) && source.tokenEnd(element.inside()) == element.insideTo()
                && !text.contains("&#") && !text.contains("]]&gt;")) {
            edits.replace(element.inside() + CDATA.length(), element.insideTo() - 3, NewText.plain(text));
        } else {
            edits.replace(element.inside(), element.insideTo(), text);
        }
    }

    private void children(Element parent, Map<String, List<Element>> parts, Form.Body old, Form.Body now, int depth) {
        Map<String, List<Form>> olds = grouped(old);
        Map<String, List<Form>> nows = grouped(now);
        Map<String, int[]> origins = new HashMap<>();
        Map<String, List<Element>> staying = new HashMap<>();
        for (String group : Form.GROUPS) {
            List<Element> elements = parts.getOrDefault(group, List.of());
            List<Form> after = nows.getOrDefault(group, List.of());
            List<Form> before = olds.getOrDefault(group, List.of());
            if (before.size() < elements.size()) {
                // What says nothing may stay if nothing is to be said.
                before = after.isEmpty() ? before : List.of(Form.of(new Form.Body(elements.get(0).name(), Map.of(), List.of(), "")));
            }
            int[] from = Alignment.of(before, after);
            origins.put(group, from);
            staying.put(group, before.size() < elements.size() ? elements : change(elements, before, after, from, depth));
        }
        for (String group : Form.GROUPS) {
            insertions.add(parent, group, parts.getOrDefault(group, List.of()), nows.getOrDefault(group, List.of()),
                    origins.getOrDefault(group, new int[0]), staying, scene);
        }
        insertions.end(parent, now.name());
    }

    /** Changes and removes elements of a group; returns those that stay where they are. */
    private List<Element> change(List<Element> elements, List<Form> before, List<Form> after, int[] from, int depth) {
        List<Element> staying = new ArrayList<>();
        int outer = scene;
        int next = 0;
        for (int j = 0; j <= from.length; j++) {
            int origin = j == from.length ? before.size() : from[j];
            if (origin < 0) {
                continue;
            }
            for (; next < origin; next++) {
                removed.add(elements.get(next), before.get(next), scene);
            }
            next = origin + 1;
            if (j < from.length) {
                Element element = elements.get(origin);
                staying.add(element);
                if (!before.get(origin).equals(after.get(j)) || after.get(j).excerpt().isPresent()) {
                    patch(element, before.get(origin), after.get(j), depth + 1);
                    scene = outer;
                } else if (element.name().equals("scene")) {
                    kept.add(new Kept(after.get(j), element));
                }
            }
        }
        return staying;
    }

    /** An element goes with its line; one that is moved, with the comments that belong to it. */
    private void remove(Removed.Piece piece) {
        Element element = piece.element();
        int start = piece.isMoved() ? layout.startWithComments(element) : element.start();
        int lineBreak = layout.lineBreakBefore(start);
        int lineEnd = layout.lineEnd(element.end());
        if (lineBreak >= 0 && lineEnd >= 0) {
            edits.remove(lineBreak, lineEnd);
        } else {
            edits.remove(start, piece.isMoved() ? layout.endWithComments(element) : element.end());
        }
    }

    private static Map<String, List<Form>> grouped(Form.Body body) {
        Map<String, List<Form>> groups = new HashMap<>();
        body.children().forEach(child -> groups.computeIfAbsent(child.group(), group -> new ArrayList<>()).add(child));
        return groups;
    }
}
