package cz.paprsek.format.gltf;

import cz.paprsek.format.model.FormatFault;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Makes values of a JSON text: maps, lists, strings, numbers and booleans; what is {@code null} is left out of maps.
 *
 * @source Bray, The JavaScript Object Notation Data Interchange Format, RFC 8259, 2017
 */
final class JsonText {
    private static final int DEEPEST = 100;
    /** Stands for null in a list. */
    private static final Object NOTHING = new Object();

    private final byte[] text;
    private int at;

    private JsonText(byte[] text) {
        this.text = text;
    }

    static Object parse(byte[] text) throws FormatFault {
        JsonText json = new JsonText(text);
        if (text.length >= 3 && text[0] == (byte) 0xEF && text[1] == (byte) 0xBB && text[2] == (byte) 0xBF) {
            json.at = 3;
        }
        Object value = json.value(0);
        json.blanks();
        // A chunk is filled up with blanks, or by careless programs with zeros.
        while (json.at < text.length && text[json.at] == 0) {
            json.at++;
        }
        if (json.at < text.length) {
            throw json.fault("something follows the end of the JSON");
        }
        return value;
    }

    private Object value(int depth) throws FormatFault {
        if (depth > DEEPEST) {
            throw fault("this is nested deeper than " + DEEPEST);
        }
        blanks();
        int c = at < text.length ? text[at] : 0;
        return switch (c) {
            case '{' -> object(depth);
            case '[' -> list(depth);
            case '"' -> string();
            case 't' -> word("true", true);
            case 'f' -> word("false", false);
            case 'n' -> word("null", NOTHING);
            default -> number();
        };
    }

    private Map<String, Object> object(int depth) throws FormatFault {
        Map<String, Object> members = new LinkedHashMap<>();
        at++;
        blanks();
        if (isNext('}')) {
            return members;
        }
        do {
            blanks();
            if (at >= text.length || text[at] != '"') {
                throw unexpected("a name in quotes");
            }
            int begin = at;
            String name = string();
            blanks();
            require(':');
            Object value = value(depth + 1);
            if (members.containsKey(name)) {
                at = begin;
                throw fault(FormatFault.quoted(name) + " is here for the second time");
            }
            if (value != NOTHING) {
                members.put(name, value);
            }
            blanks();
        } while (isNext(','));
        require('}');
        return members;
    }

    private List<Object> list(int depth) throws FormatFault {
        List<Object> values = new ArrayList<>();
        at++;
        blanks();
        if (isNext(']')) {
            return values;
        }
        do {
            values.add(value(depth + 1));
            blanks();
        } while (isNext(','));
        require(']');
        return values;
    }

    private Object word(String word, Object value) throws FormatFault {
        for (int i = 0; i < word.length(); i++) {
            if (at + i >= text.length || text[at + i] != word.charAt(i)) {
                throw unexpected("a value");
            }
        }
        at += word.length();
        return value;
    }

    private Double number() throws FormatFault {
        int begin = at;
        while (at < text.length && (Character.isDigit(text[at]) || "+-.eE".indexOf(text[at]) >= 0)) {
            at++;
        }
        String number = new String(text, begin, at - begin, StandardCharsets.US_ASCII);
        if (number.length() > 1000 || !number.matches("-?(0|[1-9]\\d*)(\\.\\d+)?([eE][-+]?\\d{1,9})?")) {
            at = begin;
            throw unexpected("a value");
        }
        double value = Double.parseDouble(number);
        if (Double.isInfinite(value)) {
            at = begin;
            throw fault("this number is too large");
        }
        return value;
    }

    private String string() throws FormatFault {
        int begin = ++at;
        StringBuilder said = new StringBuilder();
        while (at < text.length && text[at] != '"') {
            if (text[at] >= 0 && text[at] < ' ') {
                throw fault("a text must not hold control characters");
            }
            if (text[at] == '\\') {
                said.append(utf8(begin, at));
                said.append(escaped());
                begin = at;
            } else {
                at++;
            }
        }
        if (at >= text.length) {
            throw fault("the file ends within a text");
        }
        return said.append(utf8(begin, at++)).toString();
    }

    private char escaped() throws FormatFault {
        int letter = at + 1 < text.length ? text[at + 1] : 0;
        int index = "\"\\/bfnrtu".indexOf(letter);
        if (index < 0) {
            throw fault("there is no such escape in JSON");
        }
        if (letter != 'u') {
            at += 2;
            return "\"\\/\b\f\n\r\t".charAt(index);
        }
        String digits = at + 6 <= text.length ? new String(text, at + 2, 4, StandardCharsets.US_ASCII) : "";
        if (!digits.matches("[0-9a-fA-F]{4}")) {
            throw fault("after \\u must be four hexadecimal digits");
        }
        at += 6;
        return (char) Integer.parseInt(digits, 16);
    }

    private CharBuffer utf8(int from, int to) throws FormatFault {
        try {
            return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(text, from, to - from));
        } catch (CharacterCodingException e) {
            throw FormatFault.at(from, "this text is not UTF-8");
        }
    }

    private void blanks() {
        while (at < text.length && (text[at] == ' ' || text[at] == '\n' || text[at] == '\r' || text[at] == '\t')) {
            at++;
        }
    }

    private boolean isNext(char c) {
        if (at < text.length && text[at] == c) {
            at++;
            return true;
        }
        return false;
    }

    private void require(char c) throws FormatFault {
        if (!isNext(c)) {
            throw unexpected("\"" + c + "\"");
        }
    }

    private FormatFault unexpected(String wanted) {
        String found = at >= text.length ? "the end" : FormatFault.quoted(new String(text, at, Math.min(12, text.length - at), StandardCharsets.ISO_8859_1));
        return fault("here must be " + wanted + ", but is " + found);
    }

    private FormatFault fault(String sentence) {
        return FormatFault.at(at, sentence);
    }
}
