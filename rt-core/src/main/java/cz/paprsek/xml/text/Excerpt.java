package cz.paprsek.xml.text;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A scene as it is written in one file, to be put into another: every comment, instruction and word comes along. Only what must fit is changed:
 * prefixes and declarations of namespaces, line ends, and by how much all lines are indented.
 */
public final class Excerpt {
    private final Source source;
    private final String indent;
    private final Map<String, String> declaredAround;

    /**
     * @param text the element with what belongs to it before and behind it
     * @param indent of the element's line
     * @param declaredAround what prefixes stand for around it, by prefix as in {@link Source#declarations}
     */
    Excerpt(byte[] text, String indent, Map<String, String> declaredAround) {
        source = new Source(text);
        this.indent = indent;
        this.declaredAround = declaredAround;
    }

    /** As it is written within another text, without the blanks before it. */
    String within(String prefix, String newIndent, String lineBreak) {
        Edits edits = new Edits();
        Element root = source.root();
        String namespace = namespace();
        int before = root.nameTo();
        for (Source.Attribute attribute : source.attributes(root)) {
            if (attribute.name().startsWith("xmlns") && source.text(attribute.valueFrom(), attribute.valueTo()).equals(namespace)) {
                edits.remove(before, attribute.end());
            }
            before = attribute.end();
        }
        declaredAround.forEach((name, value) -> {
            if (!name.isEmpty() && !value.equals(namespace)) {
                declareIfUsed(name, value, edits);
            }
        });
        source.prefixes().forEach(old -> edits.replace(old.from(), old.to(), prefix));
        return lines(edits, newIndent, lineBreak);
    }

    static boolean hasCommentsBefore(String text) {
        return text.startsWith("<!") || text.startsWith("<?");
    }

    static boolean hasCommentsBehind(String text) {
        return text.endsWith("-->") || text.endsWith("?>");
    }

    /** As it is written in a file of its own, behind the XML declaration. */
    public String alone(String lineBreak) {
        Edits edits = new Edits();
        declaredAround.forEach((name, value) -> declareIfUsed(name, value, edits));
        return lines(edits, "", lineBreak) + lineBreak;
    }

    private String namespace() {
        String prefix = source.prefix(source.root());
        return source.declarations(source.root()).getOrDefault(prefix, declaredAround.getOrDefault(prefix, ""));
    }

    private void declareIfUsed(String prefix, String value, Edits edits) {
        Map<String, String> own = new LinkedHashMap<>(source.declarations(source.root()));
        if (!own.containsKey(prefix) && source.contains(prefix)) {
            String name = prefix.isEmpty() ? "xmlns" : "xmlns:" + prefix.substring(0, prefix.length() - 1);
            edits.insert(source.root().nameTo(), " " + name + "=\"" + value.replace("\"", "&quot;") + "\"");
        }
    }

    private String lines(Edits edits, String newIndent, String lineBreak) {
        Source fitting = new Source(edits.applied(source.bytes()));
        return new String(new Lines(fitting, indent, newIndent, lineBreak).changed(), StandardCharsets.UTF_8).strip();
    }
}
