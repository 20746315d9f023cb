package cz.paprsek.xml.mistake;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.io.PlainText;
import cz.paprsek.scene.Animation;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import cz.paprsek.text.Similar;
import cz.paprsek.xml.format.ColorWords;
import cz.paprsek.xml.format.SceneFormat;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.StringTokenizer;
import java.util.TreeSet;
import java.util.stream.Collectors;
import javax.xml.XMLConstants;
import org.xml.sax.Attributes;

/**
 * Says in our words what the schema validator found. Of the validator's messages the keys are relied on ("cvc-…", the names of the rules in the
 * standard), and the place of the attribute's name in one English sentence.
 *
 * @source W3C XML Schema Part 1: Structures, appendix C
 */
public final class Complaints {
    private static final Set<String> SURFACES = ElementTable.of(Shape.class).filter(shape -> !Solid.class.isAssignableFrom(shape)).map(ElementTable::name)
            .collect(Collectors.toUnmodifiableSet());
    private static final String MATERIAL = "material";
    /** Its materials are for objects that name them. */
    private static final String SCENE = "scene";
    private static final String OF_MATERIAL = "; it belongs in a <material> inside";
    private static final Set<String> OPERATIONS = Arrays.stream(Csg.Operation.values()).map(Described::word).collect(Collectors.toUnmodifiableSet());
    /** What is written out before a scene is read, and so not in its grammar. */
    private static final List<String> BODIES_WRITTEN_OUT = List.of("repeat", "instance");
    private static final List<String> WRITTEN_OUT = List.of("param", "define", "include", "animate", "repeat", "instance");
    private static final String ANIMATION = ElementTable.name(Animation.class);
    private static final int LONGEST_QUOTE = 60;

    private final Grammar grammar = Grammar.ofScenes();
    private final Problems problems;

    public Complaints(Problems problems) {
        this.problems = problems;
    }

    /**
     * Turns one message into problems, or none if another message says the same.
     *
     * @param path the names of the open elements, the current one last
     * @param found the attributes of the current element
     * @param isToldInside whether there are problems of the element already, or of what is inside
     */
    public void add(String message, List<String> path, Attributes found, boolean isToldInside, int line, int column) {
        String element = last(path);
        String type = grammar.type(path);
        String key = message.substring(0, Math.max(0, message.indexOf(':')));
        switch (key) {
            case "cvc-elt.1.a", "cvc-elt.1" -> {
                problems.add(line, column, wrongRoot(element));
                throw new Problems.Stop();
            }
            case "cvc-complex-type.2.4.a", "cvc-complex-type.2.4.d", "cvc-complex-type.2.4.e", "cvc-complex-type.2.4.f" ->
                problems.add(line, column, unexpected(path));
            case "cvc-complex-type.2.1" -> {
                if (!isToldInside) {
                    problems.add(line, column, "<" + element + "> must be empty, but there is something inside");
                }
            }
            case "cvc-complex-type.2.4.b" -> {
                if (!isToldInside) {
                    problems.add(line, column, element.equals(ANIMATION) || OPERATIONS.contains(element)
                            ? "<" + element + "> needs at least one " + (element.equals(ANIMATION) ? "<key>" : "solid") + " inside" : "<" + element + "> needs a pattern inside");
                }
            }
            case "cvc-complex-type.3.2.2", "cvc-type.3.1.1" -> unknownAttributes(element, type, found, line, column);
            case "cvc-complex-type.4" -> missingAttributes(element, type, found, line, column);
            case "cvc-attribute.3" -> wrongValue(message, element, type, found, line, column);
            case "cvc-type.3.1.3" -> problems.add(line, column, "<" + element + "> must hold " + grammar.expected(type));
            case "cvc-type.3.1.2" -> problems.add(line, column, "<" + element + "> holds text only, but here is an element");
            // Text where none belongs has been told already.
            case "cvc-complex-type.2.3" -> { }
            default -> {
                if (key.startsWith("cvc-elt")) {
                    instanceAttributes(element, found, line, column);
                } else if (!isRepeatedBelow(key)) {
                    problems.add(line, column, "<" + element + "> does not follow the schema of scene files (" + key + ")");
                }
            }
        }
    }

    /** Adds the problem that an element is not known where it is: the validator tells so of the first child of an element only. */
    public void addIfUnknown(List<String> path, int line, int column) {
        if (grammar.type(path).isEmpty() && !grammar.type(path.subList(0, path.size() - 1)).isEmpty()) {
            problems.add(line, column, unexpected(path));
        }
    }

    /** Adds the problem that there is text in an element, unless the element itself is one. */
    public void addText(List<String> path, String text, int line, int column) {
        if (!grammar.type(path).isEmpty()) {
            problems.add(line, column, "<" + last(path) + "> holds elements only, but here is the text \""
                    + PlainText.of(text, LONGEST_QUOTE) + "\"");
        }
    }

    /** A message about the form of a value is followed by one that names the attribute. */
    private static boolean isRepeatedBelow(String key) {
        return key.startsWith("cvc-datatype") || key.endsWith("-valid") || key.startsWith("cvc-simple");
    }

    private static String wrongRoot(String element) {
        String name = element.substring(element.indexOf('}') + 1);
        if (name.equals("scene") || name.equals("database")) {
            return "<" + name + "> must have xmlns=\"" + SceneFormat.NAMESPACE + "\", but has "
                    + (element.startsWith("{}") ? "none" : "\"" + namespace(element) + "\"");
        }
        return "a scene file starts with <scene xmlns=\"" + SceneFormat.NAMESPACE + "\"> or <database …>, but here is <" + name + ">"
                + Similar.suggestion(name, List.of("scene", "database"));
    }

    private String unexpected(List<String> path) {
        String element = last(path);
        String parent = path.size() > 1 ? path.get(path.size() - 2) : "";
        if (element.startsWith("{")) {
            return "<" + parent + "> must hold elements of the namespace " + SceneFormat.NAMESPACE + " only, but here is <"
                    + element.substring(element.indexOf('}') + 1) + "> of " + (element.startsWith("{}") ? "none" : "\"" + namespace(element) + "\"");
        }
        if (SURFACES.contains(element) && OPERATIONS.contains(parent)) {
            return "a " + element + " has no inside, so <" + parent + "> cannot use it; give it a <" + (element.equals("disc") ? "cylinder" : "block") + ">";
        }
        Map<String, String> allowed = grammar.children(grammar.type(path.subList(0, path.size() - 1)));
        if (allowed.containsKey(element)) {
            return element.equals(MATERIAL) ? "<material> must come first, and once, within <" + parent + ">"
                    : "there must be only one <" + element + "> within <" + parent + ">";
        }
        if (allowed.isEmpty()) {
            return "<" + parent + "> holds no elements, but here is <" + element + ">";
        }
        boolean isKnown = grammar.allElements().contains(element);
        Set<String> words = new TreeSet<>(allowed.keySet());
        words.addAll(parent.equals(SCENE) ? WRITTEN_OUT : OPERATIONS.contains(parent) ? BODIES_WRITTEN_OUT : List.of());
        String suggestion = Wording.suggestion(element, words);
        return "<" + parent + "> has no element <" + element + ">" + (isKnown ? " here" : "") + (!suggestion.isEmpty() ? suggestion : !isKnown ? Wording.insteadOf(element)
                : !parent.equals(SCENE) && grammar.children(allowed.getOrDefault(MATERIAL, "")).containsKey(element) ? OF_MATERIAL : "");
    }

    private void unknownAttributes(String element, String type, Attributes found, int line, int column) {
        Map<String, String> known = grammar.attributes(type);
        Set<String> free = new TreeSet<>(known.keySet());
        for (int i = 0; i < found.getLength(); i++) {
            free.remove(found.getQName(i));
        }
        for (int i = 0; i < found.getLength(); i++) {
            String name = found.getQName(i);
            if (!known.containsKey(name) && !found.getURI(i).equals(XMLConstants.W3C_XML_SCHEMA_INSTANCE_NS_URI)) {
                String suggestion = Wording.suggestion(name, free);
                boolean isOfMaterial = suggestion.isEmpty() && !element.equals(SCENE) && grammar.attributes(grammar.children(type).getOrDefault(MATERIAL, "")).containsKey(name);
                problems.add(line, column, "<" + element + "> has no attribute \"" + name + "\"" + (isOfMaterial ? OF_MATERIAL : suggestion), name);
            }
        }
        instanceAttributes(element, found, line, column);
    }

    /** Those of the namespace for instances of schemas say where a schema is, which is not looked at; the others change what an element is. */
    private void instanceAttributes(String element, Attributes found, int line, int column) {
        for (int i = 0; i < found.getLength(); i++) {
            if (found.getURI(i).equals(XMLConstants.W3C_XML_SCHEMA_INSTANCE_NS_URI) && !found.getLocalName(i).endsWith("chemaLocation")) {
                problems.add(line, column, "<" + element + "> must not have xsi:type or xsi:nil; remove them", found.getQName(i));
            }
        }
    }

    /** One that is there under a misspelt name is not called missing as well. */
    private void missingAttributes(String element, String type, Attributes found, int line, int column) {
        Set<String> misspelt = new TreeSet<>();
        for (int i = 0; i < found.getLength(); i++) {
            if (!grammar.attributes(type).containsKey(found.getQName(i))) {
                Wording.meant(found.getQName(i), grammar.attributes(type).keySet()).ifPresent(misspelt::add);
            }
        }
        for (String name : grammar.required(type)) {
            if (found.getValue(name) == null && !misspelt.contains(name)) {
                String wanted = grammar.expected(grammar.attributes(type).getOrDefault(name, ""));
                problems.add(line, column, "<" + element + "> needs the attribute " + name + ", " + wanted);
            }
        }
    }

    private void wrongValue(String message, String element, String type, Attributes found, int line, int column) {
        // … of attribute 'radius' on element …: the last such words, because the value before them is a stranger's.
        String before = " of attribute '";
        int start = message.lastIndexOf(before) + before.length();
        String name = message.substring(start, Math.max(start, message.indexOf('\'', start)));
        String value = String.valueOf(found.getValue(name));
        String typeOfValue = grammar.attributes(type).getOrDefault(name, "");
        String expected = grammar.expected(typeOfValue);
        String quoted = "\"" + PlainText.of(value, LONGEST_QUOTE) + "\"";
        boolean isNumber = !typeOfValue.equals("name");
        Optional<String> odd = LookAlikes.in(value).filter(anything -> isNumber);
        Optional<String> other = odd.isEmpty() && isNumber ? OtherNotations.advice(typeOfValue, expected, value) : Optional.empty();
        problems.add(line, column, element + " " + name + " must be " + expected + ", but "
                + odd.map(character -> "has " + character + ": " + quoted)
                        .orElseGet(() -> isWrongCount(expected, value) ? "has " + new StringTokenizer(value).countTokens() + ": " + quoted : "is " + quoted)
                + other.map(advice -> "; " + advice)
                        .orElseGet(() -> typeOfValue.equals("color") ? Similar.suggestion(value.strip(), ColorWords.names()) : ""), name);
    }

    /** Whether there are numbers, but too few or too many. */
    private static boolean isWrongCount(String expected, String value) {
        List<String> words = Collections.list(new StringTokenizer(value)).stream().map(String::valueOf).toList();
        int wanted = expected.startsWith("three ") ? 3 : expected.startsWith("two ") ? 2 : words.size();
        return !words.isEmpty() && words.stream().allMatch(OtherNotations::isNumber)
                && (expected.startsWith("one ") ? words.size() != 1 && words.size() != 3 : words.size() != wanted);
    }

    private static String last(List<String> path) {
        return path.get(path.size() - 1);
    }

    private static String namespace(String element) {
        return PlainText.of(element.substring(1, element.indexOf('}')), LONGEST_QUOTE);
    }
}
