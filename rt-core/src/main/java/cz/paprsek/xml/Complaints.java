package cz.paprsek.xml;

import cz.paprsek.io.PlainText;
import cz.paprsek.scene.Similar;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.xml.sax.Attributes;

/**
 * Says in our words what the schema validator found. Of the validator's message only the key is relied on ("cvc-…", the names of the rules in
 * the standard), since the rest comes in the language of the machine.
 *
 * @source W3C XML Schema Part 1: Structures, appendix C
 */
final class Complaints {
    private static final Set<String> SURFACES = Set.of("rectangle", "disc");
    private static final Set<String> OPERATIONS = Set.of("union", "difference", "intersection");

    private final Grammar grammar = new Grammar();
    private final Problems problems;

    Complaints(Problems problems) {
        this.problems = problems;
    }

    /**
     * Turns one message into problems, or none if another message says the same.
     *
     * @param path the names of the open elements, the current one last
     * @param found the attributes of the current element
     */
    void add(String message, List<String> path, Attributes found, int line, int column) {
        String element = path.get(path.size() - 1);
        String type = grammar.type(path);
        String parent = path.size() > 1 ? path.get(path.size() - 2) : "";
        String key = message.substring(0, Math.max(0, message.indexOf(':')));
        switch (key) {
            case "cvc-elt.1.a", "cvc-elt.1" -> problems.add(line, column, wrongRoot(element));
            case "cvc-complex-type.2.4.a", "cvc-complex-type.2.4.d", "cvc-complex-type.2.1", "cvc-complex-type.2.4.e", "cvc-complex-type.2.4.f" ->
                problems.add(line, column, unexpected(element, parent, type, path));
            case "cvc-complex-type.2.4.b" -> problems.add(line, column, "<" + element + "> needs at least one solid inside");
            case "cvc-complex-type.2.3" -> problems.add(line, column, "<" + element + "> holds elements only, but here is text");
            case "cvc-complex-type.3.2.2", "cvc-type.3.1.1" -> unknownAttributes(element, type, found, line, column);
            case "cvc-complex-type.4" -> missingAttributes(element, type, found, line, column);
            case "cvc-attribute.3" -> wrongValue(message, element, type, found, line, column);
            case "cvc-type.3.1.3" -> problems.add(line, column, "<" + element + "> must hold " + grammar.expected(type));
            case "cvc-type.3.1.2" -> problems.add(line, column, "<" + element + "> holds text only, but here is an element");
            default -> {
                if (!isRepeatedBelow(key)) {
                    problems.add(line, column, "<" + element + "> does not follow the schema of scene files (" + key + ")");
                }
            }
        }
    }

    /** A message about the form of a value is followed by one that names the attribute. */
    private static boolean isRepeatedBelow(String key) {
        return key.startsWith("cvc-datatype") || key.endsWith("-valid") || key.startsWith("cvc-simple");
    }

    private String wrongRoot(String element) {
        return "a scene file starts with <scene xmlns=\"" + SceneFiles.NAMESPACE + "\">, or <database …>, but here is <" + element + ">"
                + (Set.of("scene", "database").contains(element) ? " without that xmlns" : "");
    }

    private String unexpected(String element, String parent, String type, List<String> path) {
        if (SURFACES.contains(element) && OPERATIONS.contains(parent)) {
            return "a " + element + " has no inside, so <" + parent + "> cannot use it; give it "
                    + (element.equals("disc") ? "a <cylinder>" : "a <block>");
        }
        String parentType = grammar.type(path.subList(0, path.size() - 1));
        Map<String, String> allowed = grammar.children(parentType);
        if (allowed.containsKey(element) || !type.isEmpty()) {
            return element.equals("material") ? "<material> must come first, and once, within <" + parent + ">"
                    : "there must be only one <" + element + "> within <" + parent + ">";
        }
        if (allowed.isEmpty()) {
            return "<" + parent + "> holds no elements, but here is <" + element + ">";
        }
        String known = grammar.allElements().contains(element) ? " here" : "";
        return "<" + parent + "> has no element <" + element + ">" + known + Similar.suggestion(element, allowed.keySet());
    }

    private void unknownAttributes(String element, String type, Attributes found, int line, int column) {
        Map<String, String> known = grammar.attributes(type);
        Set<String> free = new TreeSet<>(known.keySet());
        for (int i = 0; i < found.getLength(); i++) {
            free.remove(found.getQName(i));
        }
        for (int i = 0; i < found.getLength(); i++) {
            String name = found.getQName(i);
            if (!known.containsKey(name)) {
                problems.add(line, column, "<" + element + "> has no attribute \"" + name + "\"" + Similar.suggestion(name, free));
            }
        }
    }

    private void missingAttributes(String element, String type, Attributes found, int line, int column) {
        for (String name : grammar.required(type)) {
            if (found.getValue(name) == null) {
                String wanted = grammar.expected(grammar.attributes(type).getOrDefault(name, ""));
                problems.add(line, column, "<" + element + "> needs the attribute " + name + ", " + wanted);
            }
        }
    }

    private void wrongValue(String message, String element, String type, Attributes found, int line, int column) {
        for (int i = 0; i < found.getLength(); i++) {
            String name = found.getQName(i);
            String attributeType = grammar.attributes(type).get(name);
            if (attributeType != null && message.matches("(?s).*[^\\p{L}]" + name + "[^\\p{L}-].*") && message.contains(found.getValue(i))) {
                problems.add(line, column, element + " " + name + " must be " + grammar.expected(attributeType)
                        + ", but is \"" + PlainText.of(found.getValue(i), 60) + "\"");
            }
        }
    }
}
