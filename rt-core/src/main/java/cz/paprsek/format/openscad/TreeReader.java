package cz.paprsek.format.openscad;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Transcoded;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Makes a tree of a text. */
final class TreeReader {
    private static final int DEEPEST = 200;
    private static final String MODIFIERS = "%#*!";
    /** What has no children: if something follows, a semicolon is missing. */
    private static final Set<String> BODIES = Set.of("cube", "sphere", "cylinder", "polyhedron", "square", "circle", "polygon", "import");

    private final byte[] text;
    private int at;
    private long line = 1;

    TreeReader(byte[] text) {
        this.text = text;
        at = text.length >= 3 && (text[0] & 0xFF) == 0xEF && (text[1] & 0xFF) == 0xBB ? 3 : 0;
    }

    /** What stands at the top. */
    List<Node> read() throws FormatFault {
        List<Node> nodes = new ArrayList<>();
        while (letter() != 0) {
            node(nodes, 0);
        }
        return nodes;
    }

    private void node(List<Node> into, int depth) throws FormatFault {
        if (letter() == ';') {
            at++;
            return;
        }
        if (depth > DEEPEST) {
            throw fault("this is nested deeper than " + DEEPEST);
        }
        char modifier = ' ';
        while (MODIFIERS.indexOf(letter()) >= 0) {
            modifier = (char) text[at++];
        }
        long begin = line;
        String name = word();
        if (name.isEmpty()) {
            throw unexpected("the name of a body or an operation");
        }
        Map<String, Value> arguments = arguments();
        List<Node> children = new ArrayList<>();
        if (letter() == '{') {
            at++;
            while (letter() != '}') {
                if (letter() == 0) {
                    throw fault("the file ends before the } of line " + begin);
                }
                node(children, depth + 1);
            }
            at++;
        } else if (letter() == ';') {
            at++;
        } else if (!BODIES.contains(name) && isBeginning(letter())) {
            node(children, depth + 1);
        } else {
            throw unexpected("{ or ;");
        }
        into.add(new Node(name, modifier, arguments, children, begin));
    }

    private Map<String, Value> arguments() throws FormatFault {
        take('(', "(");
        Map<String, Value> arguments = new LinkedHashMap<>();
        while (letter() != ')') {
            int before = at;
            long lineBefore = line;
            String name = word();
            if (!name.isEmpty() && letter() == '=') {
                at++;
                arguments.put(name, value(0));
            } else {
                at = before;
                line = lineBefore;
                arguments.put(Integer.toString(arguments.size()), value(0));
            }
            if (letter() != ')') {
                take(',', ", or )");
            }
        }
        at++;
        return arguments;
    }

    private Value value(int depth) throws FormatFault {
        char c = letter();
        if (c == '[') {
            if (depth > DEEPEST) {
                throw fault("lists are nested deeper than " + DEEPEST);
            }
            at++;
            List<Value> values = new ArrayList<>();
            while (letter() != ']') {
                values.add(value(depth + 1));
                if (letter() != ']') {
                    take(',', ", or ]");
                }
            }
            at++;
            return new Value.Vec(values);
        }
        if (c == '"') {
            return new Value.Text(string());
        }
        int start = at;
        while (at < text.length && (isWordLetter(text[at]) || text[at] == '-' || text[at] == '+' || text[at] == '.')) {
            at++;
        }
        String word = Transcoded.decoded(text, start, at);
        return switch (word) {
            case "true" -> new Value.Flag(true);
            case "false" -> new Value.Flag(false);
            case "undef" -> new Value.Undefined();
            case "inf", "nan", "-inf", "-nan" -> new Value.Num(Double.NaN);
            default -> {
                if (!word.matches("[-+]?(\\d{1,400}\\.?\\d{0,400}|\\.\\d{1,400})([eE][-+]?\\d{1,9})?")) {
                    throw word.isEmpty() ? unexpected("a number, a list, a text, true, false or undef") : fault("here must be a number, a list, a text, true, false or undef, but is " + FormatFault.quoted(word));
                }
                yield new Value.Num(Double.parseDouble(word));
            }
        };
    }

    private String string() throws FormatFault {
        int start = ++at;
        StringBuilder said = new StringBuilder();
        while (at < text.length && text[at] != '"') {
            if (text[at] == '\\' && at + 1 < text.length) {
                said.append(Transcoded.decoded(text, start, at));
                start = ++at;
            }
            if (text[at] == '\n') {
                line++;
            }
            at++;
        }
        if (at >= text.length) {
            throw fault("the file ends within a text");
        }
        return said.append(Transcoded.decoded(text, start, at++)).toString();
    }

    /** @param said what may stand here */
    private void take(char wanted, String said) throws FormatFault {
        if (letter() != wanted) {
            throw unexpected(said);
        }
        at++;
    }

    private FormatFault unexpected(String wanted) {
        char c = letter();
        return fault("here must be " + wanted + ", but is " + (c == 0 ? "the end" : FormatFault.quoted(Transcoded.decoded(text, at, Math.min(text.length, at + 20)).lines().findFirst().orElse(""))));
    }

    private FormatFault fault(String sentence) {
        return FormatFault.line(line, sentence);
    }

    private String word() {
        letter();
        int start = at;
        while (at < text.length && isWordLetter(text[at])) {
            at++;
        }
        return Transcoded.decoded(text, start, at);
    }

    /** Whether a body or an operation may begin so: the only child of one before it, which needs no braces. */
    private static boolean isBeginning(char c) {
        return MODIFIERS.indexOf(c) >= 0 || (c < 128 && isWordLetter((byte) c));
    }

    private static boolean isWordLetter(byte b) {
        return (b >= 'a' && b <= 'z') || (b >= 'A' && b <= 'Z') || (b >= '0' && b <= '9') || b == '_' || b == '$';
    }

    /** The next letter that is neither blank nor in a comment, which is still to be read; 0 at the end. */
    private char letter() {
        while (at < text.length) {
            byte b = text[at];
            if (b == '/' && at + 1 < text.length && text[at + 1] == '/') {
                while (at < text.length && text[at] != '\n') {
                    at++;
                }
            } else if (b > ' ' || b < 0) {
                return (char) (b & 0xFF);
            } else {
                line += b == '\n' ? 1 : 0;
                at++;
            }
        }
        return 0;
    }
}
