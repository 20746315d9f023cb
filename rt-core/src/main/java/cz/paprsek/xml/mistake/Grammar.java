package cz.paprsek.xml.mistake;

import cz.paprsek.xml.format.SceneFormat;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import javax.xml.XMLConstants;
import javax.xml.parsers.DocumentBuilderFactory;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.xml.sax.InputSource;

/** What the schema says of elements and attributes, for telling the author of a file what was expected. Made only when something is wrong. */
public final class Grammar {
    private static final String XS = XMLConstants.W3C_XML_SCHEMA_NS_URI;

    /** What may and must be in an element: attributes and elements with the names of their types. */
    private record Content(Map<String, String> attributes, Map<String, String> children, Collection<String> required) {
        Content() {
            this(new LinkedHashMap<>(), new LinkedHashMap<>(), new ArrayList<>());
        }

        void include(Content other) {
            attributes.putAll(other.attributes);
            children.putAll(other.children);
            required.addAll(other.required);
        }
    }

    private static final Content NOTHING = new Content(Map.of(), Map.of(), List.of());

    private final Map<String, Content> contents = new LinkedHashMap<>();
    /** By the name of a simple type: what completes "must be …". */
    private final Map<String, String> expected = new LinkedHashMap<>();
    /** By the name of a simple type: all values it has, if they are words. */
    private final Map<String, List<String>> words = new LinkedHashMap<>();

    /** One for all files: it is made when the first of them has a problem, and never changes. */
    private static final class OfScenes {
        private static final Grammar GRAMMAR = new Grammar(SceneFormat.schema());
    }

    /** Made when it is asked for. */
    private static final class OfWritten {
        private static final Grammar GRAMMAR = new Grammar(SceneFormat.schemaWithFormulas());
    }

    public static Grammar ofScenes() {
        return OfScenes.GRAMMAR;
    }

    /** Of files as they are written by hand, with parameters, repetition and the like. */
    public static Grammar ofWritten() {
        return OfWritten.GRAMMAR;
    }

    private Grammar(String text) {
        Element schema = parse(text);
        for (Element type : elements(schema, "simpleType")) {
            expected.put(type.getAttribute("name"), documentation(type));
            words.put(type.getAttribute("name"), elements(type, "restriction").stream().flatMap(one -> elements(one, "enumeration").stream())
                    .map(one -> one.getAttribute("value")).toList());
        }
        for (Element type : elements(schema, "complexType")) {
            Content content = new Content();
            collect(type, content, schema);
            contents.put(type.getAttribute("name"), content);
        }
        contents.put("Database", new Content(Map.of(), Map.of("scene", "Scene"), List.of()));
    }

    /** The type of the element that a path of element names leads to; empty if the schema knows no such element there. */
    public String type(List<String> path) {
        String type = path.isEmpty() ? "" : path.get(0).equals("scene") ? "Scene" : path.get(0).equals("database") ? "Database" : "";
        for (int i = 1; i < path.size(); i++) {
            type = children(type).getOrDefault(path.get(i), "");
        }
        return type;
    }

    /** The attributes of a complex type, with their types. */
    public Map<String, String> attributes(String type) {
        return contents.getOrDefault(type, NOTHING).attributes();
    }

    /** The elements within a complex type, with their types. */
    public Map<String, String> children(String type) {
        return contents.getOrDefault(type, NOTHING).children();
    }

    public Collection<String> required(String type) {
        return contents.getOrDefault(type, NOTHING).required();
    }

    /** What completes the sentence "must be …" for a simple type. */
    public String expected(String type) {
        return expected.getOrDefault(type, "something else");
    }

    /** All values of a simple type that are words; none if it has others. */
    public List<String> words(String type) {
        return words.getOrDefault(type, List.of());
    }

    /** The names of all elements there are. */
    public Collection<String> allElements() {
        Collection<String> all = new TreeSet<>(List.of("scene", "database"));
        contents.values().forEach(content -> all.addAll(content.children().keySet()));
        return all;
    }

    private void collect(Element within, Content content, Element schema) {
        for (Element element : elements(within, "*")) {
            String name = element.getAttribute("name");
            String type = local(element.getAttribute("type"));
            switch (element.getLocalName()) {
                case "attribute" -> {
                    content.attributes().put(name, type);
                    if (element.getAttribute("use").equals("required")) {
                        content.required().add(name);
                    }
                }
                case "element" -> content.children().put(name, type);
                case "group" -> elements(schema, "group").stream()
                        .filter(group -> group.getAttribute("name").equals(local(element.getAttribute("ref"))))
                        .forEach(group -> collect(group, content, schema));
                case "extension" -> {
                    content.include(contents.getOrDefault(local(element.getAttribute("base")), NOTHING));
                    collect(element, content, schema);
                }
                default -> collect(element, content, schema);
            }
        }
    }

    private static String documentation(Element type) {
        return type.getElementsByTagNameNS(XS, "documentation").item(0).getTextContent().trim();
    }

    private static List<Element> elements(Element parent, String name) {
        List<Element> found = new ArrayList<>();
        for (Node node = parent.getFirstChild(); node != null; node = node.getNextSibling()) {
            if (node instanceof Element element && (name.equals("*") || name.equals(element.getLocalName()))) {
                found.add(element);
            }
        }
        return found;
    }

    private static String local(String qualified) {
        return qualified.substring(qualified.indexOf(':') + 1);
    }

    private static Element parse(String text) {
        try {
            DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
            factory.setNamespaceAware(true);
            return factory.newDocumentBuilder().parse(new InputSource(new StringReader(text))).getDocumentElement();
        } catch (Exception e) {
            throw new IllegalStateException("the schema in the program's own jar is damaged", e);
        }
    }
}
