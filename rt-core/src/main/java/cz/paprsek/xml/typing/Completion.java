package cz.paprsek.xml.typing;

import cz.paprsek.xml.mistake.Grammar;
import cz.paprsek.xml.typing.LooseMarkup.Place;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What could be written at a place of a text of a scene, by the schema.
 *
 * @param from where what is taken begins in the text, in characters
 * @param to where that ends: what is there is replaced
 * @param expected what a value must be there, as in "must be …", or all words there are; empty if nothing is said of that
 * @param proposals what could stand there and begins with what does already
 */
public record Completion(int from, int to, String expected, List<Proposal> proposals) {
    /** Names of the schema's types of what may be a formula, too. */
    private static final String OR_FORMULA = "OrFormula";
    private static final Pattern ATTRIBUTES = Pattern.compile("\\G[^<>]*?([A-Za-z-]+)\\s*=\\s*(?:\"[^\"<]*\"|'[^'<]*')");

    /** What is proposed. */
    public enum Kind { ELEMENT, END_TAG, ATTRIBUTE, VALUE }

    /**
     * Something that could be written.
     *
     * @param name of the element, attribute or value
     * @param text what is written
     * @param caret where in that the caret comes to stand
     * @param expected of an attribute what its value must be, as in "must be …"; else empty
     * @param isRequired whether there must be such an attribute
     */
    public record Proposal(Kind kind, String name, String text, int caret, String expected, boolean isRequired) {
        public Proposal {
            Objects.requireNonNull(kind, "kind");
            Objects.requireNonNull(name, "name");
            Objects.requireNonNull(text, "text");
            Objects.requireNonNull(expected, "expected");
        }
    }

    /**
     * The names that values may be.
     *
     * @param materials that bodies can name
     * @param definitions that can be used
     * @param targets that can be animated
     */
    public record Names(Collection<String> materials, Collection<String> definitions, Collection<String> targets) {
        public Names {
            materials = List.copyOf(materials);
            definitions = List.copyOf(definitions);
            targets = List.copyOf(targets);
        }
    }

    public Completion {
        Objects.requireNonNull(expected, "expected");
        proposals = List.copyOf(proposals);
    }

    /** What could be written at a place, from 0; nothing in comments and the like. */
    public static Completion at(String text, int place, Names names) {
        Objects.requireNonNull(names, "names");
        LooseMarkup before = LooseMarkup.of(text.substring(0, place));
        Grammar grammar = Grammar.ofWritten();
        return switch (before.place()) {
            case CONTENT -> new Completion(place, place, "", elements(before, "", grammar));
            case NAME, END_TAG -> new Completion(before.begin(), place, "", elements(before, text.substring(before.begin(), place), grammar));
            case ATTRIBUTE -> attributes(before, text, place, grammar);
            case VALUE -> value(before, text, place, grammar, names);
            case ELSEWHERE -> new Completion(place, place, "", List.of());
        };
    }

    private static List<Proposal> elements(LooseMarkup before, String written, Grammar grammar) {
        List<String> around = before.around();
        List<Proposal> found = new ArrayList<>();
        if (!around.isEmpty()) {
            String end = "</" + around.get(around.size() - 1) + ">";
            add(found, new Proposal(Kind.END_TAG, end, end, end.length(), "", false), end, written);
        }
        Map<String, String> known = around.isEmpty() ? Map.of("scene", "Scene") : grammar.children(grammar.type(around));
        boolean isEmptyFile = around.isEmpty() && !before.spans().isEmpty();
        if (before.place() != Place.END_TAG && !isEmptyFile) {
            known.forEach((name, type) -> add(found, element(name, grammar.required(type), type), "<" + name, written));
        }
        if (written.length() > 1) {
            // What is written in full already comes first.
            found.sort(Comparator.comparingInt(one -> one.name().length()));
        }
        return found;
    }

    private static void add(List<Proposal> found, Proposal one, String as, String written) {
        if (as.startsWith(written)) {
            found.add(one);
        }
    }

    private static Proposal element(String name, Collection<String> required, String type) {
        StringBuilder text = new StringBuilder("<").append(name);
        required.forEach(attribute -> text.append(' ').append(attribute).append("=\"\""));
        boolean holdsText = type.equals("text");
        text.append(holdsText ? "></" + name + ">" : "/>");
        int quotes = text.indexOf("\"\"");
        int caret = quotes >= 0 ? quotes + 1 : holdsText ? name.length() + 2 : text.length() - 2;
        return new Proposal(Kind.ELEMENT, name, text.toString(), caret, "", false);
    }

    private static Completion attributes(LooseMarkup before, String text, int place, Grammar grammar) {
        String type = type(before, grammar);
        String written = text.substring(before.begin(), place);
        List<String> given = new ArrayList<>(before.given());
        Matcher behind = ATTRIBUTES.matcher(text.substring(place));
        while (behind.find()) {
            given.add(behind.group(1));
        }
        List<Proposal> found = new ArrayList<>();
        for (boolean isRequired : new boolean[] {true, false}) {
            grammar.attributes(type).forEach((name, kind) -> {
                if (grammar.required(type).contains(name) == isRequired && !given.contains(name)) {
                    String space = written.isEmpty() && place > 0 && !Character.isWhitespace(text.charAt(place - 1)) ? " " : "";
                    add(found, new Proposal(Kind.ATTRIBUTE, name, space + name + "=\"\"", space.length() + name.length() + 2, expected(grammar, kind), isRequired), name, written);
                }
            });
        }
        return new Completion(before.begin(), place, "", found);
    }

    private static Completion value(LooseMarkup before, String text, int place, Grammar grammar, Names names) {
        String kind = grammar.attributes(type(before, grammar)).getOrDefault(before.attribute(), "");
        String written = text.substring(before.begin(), place);
        Collection<String> words = before.attribute().equals("material") ? names.materials()
                : before.attribute().equals("of") ? names.definitions()
                : before.tag().equals("animate") && before.attribute().equals("target") ? names.targets()
                : grammar.words(base(kind).equals("color") ? "colorName" : base(kind));
        int end = place;
        while (end < text.length() && "\"'<>\n".indexOf(text.charAt(end)) < 0) {
            end++;
        }
        int to = end;
        List<Proposal> found = new ArrayList<>();
        words.forEach(word -> add(found, new Proposal(Kind.VALUE, word, word, word.length(), "", false), word, written));
        return new Completion(before.begin(), to, expected(grammar, kind), found);
    }

    private static String type(LooseMarkup before, Grammar grammar) {
        List<String> path = new ArrayList<>(before.around());
        path.add(before.tag());
        return grammar.type(path);
    }

    private static String base(String kind) {
        return kind.endsWith(OR_FORMULA) ? kind.substring(0, kind.length() - OR_FORMULA.length()) : kind;
    }

    private static String expected(Grammar grammar, String kind) {
        List<String> words = grammar.words(base(kind));
        return words.isEmpty() ? grammar.expected(base(kind)) : String.join(" | ", words);
    }
}
