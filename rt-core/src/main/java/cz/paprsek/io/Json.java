package cz.paprsek.io;

import cz.paprsek.math.Vec3;
import cz.paprsek.text.Numbers;
import java.util.Arrays;
import java.util.Collection;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.Collectors;

/**
 * A JSON object in the making, members in the order they are added. Only ASCII: what is not is escaped, so that neither a terminal nor a
 * pipe with another encoding can misread it.
 */
public final class Json {
    private final StringBuilder members = new StringBuilder();

    public Json with(String name, String value) {
        return member(name, quoted(value));
    }

    public Json with(String name, long value) {
        return member(name, Long.toString(value));
    }

    public Json with(String name, boolean value) {
        return member(name, Boolean.toString(value));
    }

    /** A number; {@code null} for one that JSON cannot write. */
    public Json with(String name, double value) {
        return member(name, number(value));
    }

    public Json with(String name, Vec3 value) {
        return withNumbers(name, value.x(), value.y(), value.z());
    }

    /** A value of whatever kind an attribute has: a number, a flag, three numbers, or else a text; nothing of an optional that is empty. */
    public Json withValue(String name, Object value) {
        if (value instanceof OptionalDouble optional) {
            return optional.isPresent() ? with(name, optional.getAsDouble()) : this;
        }
        return value instanceof Number number ? with(name, number.doubleValue()) : value instanceof Boolean flag ? with(name, flag.booleanValue())
                : value instanceof Vec3 numbers ? with(name, numbers) : value instanceof double[] pair ? withNumbers(name, pair)
                : with(name, value instanceof Enum<?> word ? word.name().toLowerCase(Locale.ROOT).replace('_', '-') : value.toString());
    }

    public Json with(String name, Json value) {
        return member(name, value.toString());
    }

    public Json with(String name, Collection<Json> values) {
        return member(name, values.stream().map(Json::toString).collect(Collectors.joining(",", "[", "]")));
    }

    public Json withNumbers(String name, double... values) {
        return member(name, Arrays.stream(values).mapToObj(Json::number).collect(Collectors.joining(",", "[", "]")));
    }

    public Json withTexts(String name, Collection<String> values) {
        return member(name, values.stream().map(Json::quoted).collect(Collectors.joining(",", "[", "]")));
    }

    /** The object in one line. */
    @Override
    public String toString() {
        return "{" + members + "}";
    }

    private Json member(String name, String value) {
        members.append(members.length() > 0 ? "," : "").append(quoted(name)).append(':').append(value);
        return this;
    }

    private static String number(double value) {
        return Double.isFinite(value) ? Numbers.text(value) : "null";
    }

    private static String quoted(String text) {
        StringBuilder quoted = new StringBuilder("\"");
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c == '"' || c == '\\') {
                quoted.append('\\').append(c);
            } else if (c < ' ' || c > '~') {
                quoted.append(String.format("\\u%04x", (int) c));
            } else {
                quoted.append(c);
            }
        }
        return quoted.append('"').toString();
    }
}
