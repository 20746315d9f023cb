package cz.paprsek.xml.text;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Where the elements of a file begin, by line and column; for any number of questions. Not for several threads at once. */
public final class Places {
    private final Source source;
    private final List<Integer> lines = new ArrayList<>();
    private final Map<Element, List<Element>> children = new HashMap<>();

    /**
     * One element among others: which one of its group, from 0.
     *
     * @param group "body", "light", "material", "camera" or "scene"
     */
    public record Step(String group, int number) {
        boolean goesTo(String element) {
            return Form.group(element).equals(group);
        }
    }

    /** Both from 1, in characters. */
    public record Place(int line, int column) {}

    Places(Source source) {
        this.source = source;
    }

    private void findLines() {
        byte[] text = source.bytes();
        lines.add(0);
        for (int i = 0; i < text.length; i++) {
            if (text[i] == '\n' || (text[i] == '\r' && !source.has("\n", i + 1))) {
                lines.add(i + 1);
            }
        }
    }

    /**
     * The place of an element, or of one of its attributes.
     *
     * @param scene which scene of a database it is in, from 0
     * @param way from within the scene inwards; empty for the scene itself
     * @param attribute of the element, or of a material that is inside it; if there is none, or the name is empty, the element is meant
     * @throws Unpatchable if there is no such element
     */
    public Place of(int scene, List<Step> way, String attribute) {
        Element at = scene(scene);
        for (Step step : way) {
            at = child(at, step);
        }
        return place(start(at, attribute));
    }

    /**
     * The place of the first attribute that names a file; of the scene if there is none, or it is written in other letters.
     *
     * @param scene which scene of a database it is in, from 0
     * @param attributes the names of those that may
     */
    public Place naming(int scene, List<String> attributes, String file) {
        return place(descendants(scene(scene)).flatMap(one -> source.attributes(one).stream())
                .filter(one -> attributes.contains(one.name()) && source.text(one.valueFrom(), one.valueTo()).equals(file)).map(Source.Attribute::start)
                .findFirst().orElse(scene(scene).start()));
    }

    private Stream<Element> descendants(Element element) {
        return Stream.concat(Stream.of(element), source.children(element).stream().flatMap(this::descendants));
    }

    private Element scene(int scene) {
        return source.root().name().equals("scene") ? source.root() : child(source.root(), new Step("scene", scene));
    }

    private Place place(int start) {
        if (lines.isEmpty()) {
            findLines();
        }
        int line = Collections.binarySearch(lines, start);
        int number = line < 0 ? -line - 1 : line + 1;
        String before = source.text(lines.get(number - 1), start);
        return new Place(number, before.length() + (before.startsWith("\uFEFF") ? 0 : 1));
    }

    private int start(Element element, String attribute) {
        Stream<Element> materials = attribute.isEmpty() ? Stream.of() : source.children(element).stream().filter(child -> child.name().equals("material"));
        return Stream.concat(Stream.of(element), materials).flatMap(one -> source.attributes(one).stream())
                .filter(one -> one.name().equals(attribute)).map(Source.Attribute::start).findFirst().orElse(element.start());
    }

    private Element child(Element parent, Step step) {
        return children.computeIfAbsent(parent, source::children).stream().filter(child -> step.goesTo(child.name())).skip(step.number()).findFirst()
                .orElseThrow(() -> new Unpatchable("there is no " + step));
    }
}
