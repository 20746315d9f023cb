package cz.paprsek.words;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Sentences that tell what is wrong with a scene, a formula, a filter or their files have their lines in Czech. They are found in the sources: texts that are given, where they
 * stand, to what makes a mistake, put together with + and with blanks for what differs; and in some files all that looks like a sentence, whatever is done with it. Not seen are,
 * in other files, what comes by a constant, a variable, a method or a text block, and helpers that are not named here.
 */
class EverySentenceTest {
    private static final Words CZECH = Words.in(Locale.forLanguageTag("cs"));
    private static final Path SOURCES = Path.of("src", "main", "java", "cz", "paprsek");
    /** Where what a user writes is read. Readers of other programs' models and pictures, and what is asked for on the command line only, tell in English. */
    private static final Pattern ROOMS = Pattern.compile("(asset|attribute|formula|io|material|pov|query|scene|shape|xml)/.*");
    /** What only a programmer, or who works on the command line, is told. */
    private static final Pattern APART = Pattern.compile("attribute/(Described|ElementTable)|query/SceneTables|scene/(CustomLight|ScenePath)|shape/placed/.*|shape/check/Problems|shape/mesh/(Growing|TriangleCheck)|"
            + "xml/(Frames|Making|OriginalText|SceneFile)|xml/bind/Adapters|xml/format/.*");
    /** What a sentence is given to. */
    private static final Pattern TELLS = Pattern.compile("Require\\.that|(?!IllegalState|UnsupportedOperation|Cancellation|Uncheckedio|SAXParse)\\w*Exception|Misplaced|Refused|Rule|\\w*[mM]istakes\\.add|problems\\.add|found\\.add|sentences\\.add|lost\\.add|wrong|(\\w+\\.)?refused|require|fault|check|fail");
    /** Where sentences are also returned, kept or chosen: each text of several words is asked for. */
    private static final Pattern WHOLE = Pattern.compile("xml/bind/(Elements|Prolog)|xml/mistake/(Complaints|Malformed)|shape/font/(Font|Table)");
    private static final Pattern TOKEN = Pattern.compile("//[^\n]*|/\\*.*?\\*/|\"\"\".*?\"\"\"|\"((?:[^\"\\\\]|\\\\.)*)\"|'(?:[^'\\\\]|\\\\.)+'", Pattern.DOTALL);
    private static final Pattern CALLEE = Pattern.compile("([@\\w.]+)\\s*$");
    private static final Pattern ENGLISH = Pattern.compile("(?U)\\b(the|is|must|but|has|of|not|there|are|be|which|than|or|and|it|with|for|this|its|from|needs|that|here)\\b(?![^<]*>)");
    /** In those files: the parser's words, samples, and the middle of a sentence. */
    private static final Pattern NO_SENTENCE = Pattern.compile("[A-Z(].*| ?of .*|<[^>]*>", Pattern.DOTALL);
    /** What may stand before a sentence, and what after many of them. */
    private static final String SUGGESTION = "; did you mean \"x\"?";
    private static final String[] BEFORE = {"", "file.xml: ", "character 3: "};

    /** A source with all texts blanked, and what they say where. */
    private record Source(String code, List<int[]> places, List<String> texts) {
        static Source of(String java) {
            StringBuilder code = new StringBuilder(java);
            List<int[]> places = new ArrayList<>();
            List<String> texts = new ArrayList<>();
            for (Matcher token = TOKEN.matcher(java); token.find(); ) {
                for (int i = token.start(); i < token.end(); i++) {
                    code.setCharAt(i, token.group(1) == null ? ' ' : '_');
                }
                if (token.group(1) != null) {
                    places.add(new int[] {token.start(), token.end()});
                    texts.add(token.group(1).replace("\\\\", "\0").replace("\\u", "u").translateEscapes().replace('\0', '\\'));
                }
            }
            return new Source(code.toString(), places, texts);
        }

        /** Whether something around a place, within its statement, makes a mistake. */
        boolean isTold(int from) {
            int depth = 0;
            for (int i = from - 1; i >= 0 && ";{}".indexOf(code.charAt(i)) < 0; i--) {
                char c = code.charAt(i);
                depth += c == ')' ? 1 : c == '(' ? -1 : 0;
                if (depth < 0) {
                    depth = 0;
                    Matcher callee = CALLEE.matcher(code.substring(Math.max(0, i - 80), i));
                    if (callee.find() && TELLS.matcher(callee.group(1)).matches()) {
                        return true;
                    }
                }
            }
            return false;
        }

        /** The sentences, with a blank to fill in, §, for each part that is no text. */
        Stream<String> sentences(boolean isWhole) {
            List<String> found = new ArrayList<>();
            int end = 0;
            for (int i = 0; i < texts.size(); i++) {
                int from = places.get(i)[0];
                if (from >= end && (isWhole || isTold(from))) {
                    StringBuilder sentence = new StringBuilder(code.substring(0, from).stripTrailing().endsWith("+") ? "§" : "");
                    end = read(from, sentence);
                    if (!isWhole || isTold(from) || !NO_SENTENCE.matcher(sentence).matches()) {
                        found.add(sentence.toString());
                    }
                }
            }
            return found.stream();
        }

        private int read(int from, StringBuilder sentence) {
            int at = from;
            while (true) {
                int text = textAt(at);
                sentence.append(text >= 0 ? texts.get(text) : "§");
                at = text >= 0 ? places.get(text)[1] : endOfTerm(at);
                int plus = at;
                while (plus < code.length() && Character.isWhitespace(code.charAt(plus))) {
                    plus++;
                }
                if (plus >= code.length() || code.charAt(plus) != '+') {
                    return at;
                }
                at = plus + 1;
                while (Character.isWhitespace(code.charAt(at))) {
                    at++;
                }
            }
        }

        private int textAt(int at) {
            for (int i = 0; i < places.size(); i++) {
                if (places.get(i)[0] == at) {
                    return i;
                }
            }
            return -1;
        }

        private int endOfTerm(int from) {
            int depth = 0;
            for (int i = from; i < code.length(); i++) {
                char c = code.charAt(i);
                if (depth == 0 && ",;?+)]}".indexOf(c) >= 0) {
                    return i;
                }
                depth += "([{".indexOf(c) >= 0 ? 1 : ")]}".indexOf(c) >= 0 ? -1 : 0;
            }
            return code.length();
        }
    }

    private static Stream<String> untold(Path file) {
        try {
            return Source.of(Files.readString(file)).sentences(WHOLE.matcher(name(file).replaceFirst("\\.java$", "")).matches()).filter(sentence -> sentence.strip().matches("(?s).*[a-z]{2}.* .*[a-z]{2}.*"))
                    .filter(sentence -> Stream.of(BEFORE).noneMatch(before -> isCzech(before + filled(sentence)) || isCzech(before + filled(sentence.replaceFirst("§$", SUGGESTION)))
                            || isCzech(before + filled(sentence.replaceFirst("§+$", SUGGESTION)))))
                    .map(sentence -> SOURCES.relativize(file) + ": " + sentence);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private static String filled(String sentence) {
        AtomicInteger number = new AtomicInteger();
        return Pattern.compile("§").matcher(sentence).replaceAll(hole -> "X" + number.incrementAndGet());
    }

    private static boolean isCzech(String sentence) {
        String said = CZECH.sentence(sentence);
        return !said.equals(sentence) && !ENGLISH.matcher(said.replaceAll("\"[^\"]*\"", "")).find();
    }

    private static String name(Path file) {
        return SOURCES.relativize(file).toString().replace('\\', '/');
    }

    private static boolean isAsked(Path file) {
        String name = name(file);
        return name.endsWith(".java") && ROOMS.matcher(name).matches() && !APART.matcher(name.substring(0, name.length() - 5)).matches();
    }

    @Test
    void eachHasItsLineInCzech() throws IOException {
        try (Stream<Path> files = Files.walk(SOURCES)) {
            assertThat(files.filter(EverySentenceTest::isAsked).flatMap(EverySentenceTest::untold)).as("sentences_cs.txt lacks").isEmpty();
        }
    }

    @Test
    void sentencesAreFound() {
        String java = "class A { void a() { Require.that(b, \"the {\" + c(1, \"x y\") + \" must be \\\"\" + d + \"\\\", but\"); } /* throw new IOException(\"no one is told\"); */ String s = \"nor this one\"; }";
        assertThat(Source.of(java).sentences(false)).containsExactly("the {§ must be \"§\", but");
        assertThat(Source.of(java).sentences(true)).contains("nor this one");
        assertThat(isCzech("there is no material named \"gols\"")).isTrue();
        assertThat(isCzech("there is no such sentence in the table")).isFalse();
        assertThat(isCzech("gizmo must be round, but X1")).as("by no general line").isFalse();
    }
}
