package cz.paprsek.xml.text;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** An element in the form that is written when there is no text yet; worked out when it is looked into. Equal if it stands for equal things. */
public final class Form {
    /** What is neither body nor light, each an element or a choice of some. All bodies are one group, whose order matters, and so are all lights. */
    static final List<String> GROUPS = List.of("description", "param", "include", "define", "render", "background", "sky", "ambient", "camera", "light", "material",
            "pattern", "diffusion", "specular", "reflection", "transparency", "roughness", "relief", "scene", "body", "animate", "key");
    private static final String LIGHT = "-light";
    private static final Set<String> NAMES = Set.copyOf(GROUPS);
    private static final Set<String> PATTERNS = Set.of("checkerboard", "checker", "gradient", "stripes", "brick", "marble", "wood", "granite", "noise", "image");
    private static final Set<String> RELIEFS = Set.of("bump", "normal-map");

    private final String group;
    private final Object value;
    private final Supplier<Body> maker;
    private final Optional<Excerpt> excerpt;
    private @Nullable Body body;

    /**
     * What makes the element.
     *
     * @param attributes by name, in the order in which they are written, their values as they stand between double quotes
     * @param content the text of an element that has no others inside, as it stands between its tags
     */
    public record Body(String name, Map<String, String> attributes, List<Form> children, String content) {
        Body nameless() {
            Map<String, String> others = new LinkedHashMap<>(attributes);
            others.remove("name");
            return new Body(name, others, children, content);
        }

        String attribute(String wanted) {
            return attributes.getOrDefault(wanted, "");
        }
    }

    private Form(String group, Object value, Supplier<Body> maker, Optional<Excerpt> excerpt) {
        this.group = group;
        this.value = value;
        this.maker = maker;
        this.excerpt = excerpt;
    }

    /**
     * An element that stands for something.
     *
     * @param element its name, or that of any other body or light if it is one
     * @param value what it stands for
     */
    public static Form of(String element, Object value, Supplier<Body> maker) {
        return new Form(group(element), value, maker, Optional.empty());
    }

    /** The element of such a text. */
    public static Form parse(String xml) {
        Source source = new Source(xml.getBytes(StandardCharsets.UTF_8));
        return of(source, source.root());
    }

    static Form of(Body body) {
        return new Form(group(body.name()), body, () -> body, Optional.empty());
    }

    private static Form of(Source source, Element element) {
        Map<String, String> attributes = new LinkedHashMap<>();
        source.attributes(element).forEach(found -> attributes.put(found.name(), source.text(found.valueFrom(), found.valueTo())));
        List<Form> children = new ArrayList<>();
        source.children(element).forEach(child -> children.add(of(source, child)));
        String content = children.isEmpty() && !element.isEmpty() ? source.text(element.inside(), element.insideTo()) : "";
        return of(new Body(element.name(), attributes, children, content));
    }

    /** The same element; where it comes into a text, it comes as it is written elsewhere. */
    public Form as(Excerpt writtenElsewhere) {
        return new Form(group, value, maker, Optional.of(writtenElsewhere));
    }

    /** What the element is one of: all bodies are one group, and so are all lights. */
    public static String group(String element) {
        return NAMES.contains(element) ? element : element.endsWith(LIGHT) ? "light" : PATTERNS.contains(element) ? "pattern" : RELIEFS.contains(element) ? "relief" : "body";
    }

    String group() {
        return group;
    }

    Optional<Excerpt> excerpt() {
        return excerpt;
    }

    public Body body() {
        if (body == null) {
            body = maker.get();
        }
        return body;
    }

    @Override
    public boolean equals(Object other) {
        return this == other || (other instanceof Form form && group.equals(form.group) && value.equals(form.value));
    }

    @Override
    public int hashCode() {
        return value.hashCode();
    }

    @Override
    public String toString() {
        return group + " " + value;
    }
}
