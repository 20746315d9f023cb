package cz.paprsek.lesson;

import cz.paprsek.io.PlainText;
import cz.paprsek.text.Numbers;
import cz.paprsek.text.Similar;
import cz.paprsek.xml.Problem;
import cz.paprsek.xml.bind.PlainElements;
import cz.paprsek.xml.bind.PlainElements.Element;
import cz.paprsek.xml.bind.PlainElements.Refused;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** An element of a lesson's file: asked for what it has to have, it says where that is missing or wrong. */
final class Tag {
    private static final String NAMESPACE = "urn:paprsek:lesson:1";
    private static final int LONGEST_MESSAGE = 400;

    private final String file;
    private final Element element;
    private final String name;
    private final Map<String, String> attributes;
    private final List<Tag> children = new ArrayList<>();

    private Tag(String file, Element element) throws LessonException {
        this.file = file;
        this.element = element;
        this.name = element.name();
        this.attributes = element.attributes();
        if (!element.namespace().equals(NAMESPACE)) {
            throw wrong("<" + name + "> must be in the namespace of lessons; write <lesson xmlns=\"" + NAMESPACE + "\">"
                    + (element.namespace().isEmpty() ? "" : ", not \"" + element.namespace() + "\""));
        }
        for (Element child : element.children()) {
            children.add(new Tag(file, child));
        }
    }

    /**
     * The outermost element.
     *
     * @param file its name, for messages
     * @throws LessonException if that is no XML, or not in the namespace of lessons
     */
    static Tag read(byte[] bytes, String file) throws LessonException, IOException {
        try {
            return new Tag(file, PlainElements.read(bytes));
        } catch (Refused refused) {
            throw new LessonException(List.of(new Problem(file, refused.line(), refused.column(), String.valueOf(refused.getMessage()))));
        }
    }

    String name() {
        return name;
    }

    List<Tag> children() {
        return children;
    }

    /** What is wrong here. */
    LessonException wrong(String sentence) {
        return new LessonException(List.of(new Problem(file, element.line(), element.column(), PlainText.of(sentence, LONGEST_MESSAGE))));
    }

    /** @throws LessonException if there is an attribute that is not among these */
    void mayHave(List<String> known) throws LessonException {
        for (String attribute : attributes.keySet()) {
            if (!known.contains(attribute)) {
                throw wrong("<" + name + "> has no attribute \"" + attribute + "\"" + Similar.suggestion(attribute, known)
                        + (known.isEmpty() ? "; it has none" : Similar.nearest(attribute, known).isEmpty() ? "; it has " + String.join(", ", known) : ""));
            }
        }
    }

    /** @throws LessonException if there is an element within that is not among these, or text beside them */
    void mayHold(List<String> known) throws LessonException {
        for (Tag child : children) {
            if (!known.contains(child.name)) {
                throw child.wrong("<" + name + "> has no element <" + child.name + ">" + Similar.suggestion(child.name, known)
                        + (known.isEmpty() ? "; it has none" : Similar.nearest(child.name, known).isEmpty() ? "; it has " + String.join(", ", known) : ""));
            }
        }
        if (!known.isEmpty() && !element.text().toString().isBlank()) {
            throw wrong("<" + name + "> holds elements, not text, but here is \"" + PlainText.of(element.text().toString().strip(), 40) + "\"");
        }
    }

    Optional<String> attribute(String attribute) {
        return Optional.ofNullable(attributes.get(attribute));
    }

    /** @throws LessonException if it is missing */
    String needed(String attribute) throws LessonException {
        return attribute(attribute).orElseThrow(() -> wrong("<" + name + "> needs the attribute " + attribute));
    }

    /** The one element within of that name. @throws LessonException if it is missing, or there are several */
    Tag only(String child) throws LessonException {
        List<Tag> found = all(child);
        if (found.size() != 1) {
            throw found.isEmpty() ? wrong("<" + name + "> needs <" + child + ">") : found.get(1).wrong("<" + name + "> has <" + child + "> twice; remove one of them");
        }
        return found.get(0);
    }

    List<Tag> all(String child) {
        return children.stream().filter(one -> one.name.equals(child)).toList();
    }

    /** Its text, with a blank for each row of white space. @throws LessonException if there is none */
    String words() throws LessonException {
        mayHold(List.of());
        mayHave(List.of());
        String words = element.text().toString().strip().replaceAll("\\s+", " ");
        if (words.isEmpty()) {
            throw wrong("<" + name + "> is empty; it needs a text");
        }
        return words;
    }

    /** Numbers with blanks between. @throws LessonException if there is something else */
    List<Double> numbers(String attribute) throws LessonException {
        List<Double> numbers = new ArrayList<>();
        for (String word : needed(attribute).strip().split("\\s+", -1)) {
            numbers.add(number(attribute, word));
        }
        return numbers;
    }

    private double number(String attribute, String word) throws LessonException {
        return Numbers.parsed(word).orElseThrow(() -> wrong("<" + name + "> " + attribute + " must be numbers with blanks between, but has \"" + word + "\""));
    }

    /** A whole number; the given one if the attribute is missing. @throws LessonException if it is none, or lower or higher */
    int whole(String attribute, int otherwise, int low, int high) throws LessonException {
        Optional<String> given = attribute(attribute);
        if (given.isEmpty()) {
            return otherwise;
        }
        try {
            int number = Integer.parseInt(given.get().strip());
            if (number >= low && number <= high) {
                return number;
            }
        } catch (NumberFormatException none) {
            // Told below.
        }
        throw wrong("<" + name + "> " + attribute + " must be a whole number from " + low + " to " + high + ", but is \"" + given.get() + "\"");
    }
}
