package cz.paprsek.xml.recipe;

import cz.paprsek.xml.format.SceneFormat;
import cz.paprsek.xml.recipe.Node.Attr;
import cz.paprsek.xml.recipe.Template.Misplaced;
import cz.paprsek.xml.text.Element;
import cz.paprsek.xml.text.Source;
import cz.paprsek.xml.text.Unpatchable;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads the elements of a well-formed text, whatever they are. */
final class NodeReader {
    /** Names and texts, in which braces are braces. */
    private static final Set<String> TEXTS = Set.of("name", "material", "file", "part", "tags", "font");

    private static final Pattern COMMENT = Pattern.compile("(?s)<!--.*?-->|<\\?.*?\\?>");
    private static final Pattern CDATA = Pattern.compile("(?s)<!\\[CDATA\\[(.*?)]]>");

    private final Source source;
    private final Origin origin;
    private final Complaint complaint;

    private NodeReader(Source source, Origin origin, Complaint complaint) {
        this.source = source;
        this.origin = origin;
        this.complaint = complaint;
    }

    /** Hears what is wrong. */
    @FunctionalInterface
    interface Complaint {
        void about(Origin origin, int at, String message);
    }

    /**
     * Reads them.
     *
     * @param utf8 well-formed XML
     * @throws Unpatchable if it is no scene file, or nested too deeply
     */
    static Node read(byte[] utf8, String file, Complaint complaint) {
        Source source = new Source(utf8);
        if (!SceneFormat.NAMESPACE.equals(source.declarations(source.root()).get(source.prefix(source.root())))) {
            throw new Unpatchable("another namespace");
        }
        return new NodeReader(source, new Origin(file, utf8), complaint).node(source.root(), 1);
    }

    private Node node(Element element, int depth) {
        if (depth > SceneFormat.DEEPEST) {
            throw new Unpatchable("too deep");
        }
        String prefix = source.prefix(element);
        if (!prefix.equals(source.prefix(source.root())) || !SceneFormat.NAMESPACE.equals(source.declarations(element).getOrDefault(prefix, SceneFormat.NAMESPACE))) {
            throw new Unpatchable("another namespace");
        }
        List<Attr> attributes = new ArrayList<>();
        for (Source.Attribute one : source.attributes(element)) {
            if (!isOfParsers(one.name())) {
                attributes.add(attribute(element.name(), one));
            }
        }
        List<Node> children = new ArrayList<>();
        for (Element child : source.children(element)) {
            children.add(node(child, depth + 1));
        }
        String content = children.isEmpty() && !element.isEmpty() ? content(source.text(element.inside(), element.insideTo())) : "";
        return new Node(element.name(), attributes, children, content, origin, element.start());
    }

    /** Without comments and instructions, and with sections of plain text as others. */
    private static String content(String raw) {
        String plain = raw.indexOf('<') < 0 ? raw
                : CDATA.matcher(COMMENT.matcher(raw).replaceAll("")).replaceAll(section -> Matcher.quoteReplacement(Raw.of(section.group(1))));
        return plain.isBlank() ? "" : plain;
    }

    private Attr attribute(String element, Source.Attribute one) {
        String raw = source.text(one.valueFrom(), one.valueTo());
        boolean isText = TEXTS.contains(one.name()) || (element.equals("text") && one.name().equals("value")) || (element.equals(Node.ANIMATE) && one.name().equals("target"));
        Optional<Template> template = Optional.empty();
        if (!isText && Template.isIn(raw)) {
            try {
                template = Optional.of(Template.of(Raw.text(raw)));
            } catch (Misplaced wrong) {
                complaint.about(origin, one.valueFrom() + origin.bytes(one.valueFrom(), wrong.at()), String.valueOf(wrong.getMessage()));
            }
        }
        return new Attr(one.name(), raw, template, one.start(), one.valueFrom());
    }

    private static boolean isOfParsers(String name) {
        return name.equals("xmlns") || name.startsWith("xmlns:") || name.startsWith("xsi:") || name.startsWith("xml:");
    }
}
