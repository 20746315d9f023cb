package cz.paprsek.cli;

import cz.paprsek.math.Numbers;
import cz.paprsek.math.Vec3;
import java.util.Collection;
import java.util.stream.Collectors;

/**
 * A JSON object in the making, members in the order they are added. Only ASCII: what is not is escaped, so that neither a terminal nor a
 * pipe with another encoding can misread it.
 */
final class Json {
    private final StringBuilder members = new StringBuilder();

    Json with(String name, String value) {
        return member(name, quoted(value));
    }

    Json with(String name, long value) {
        return member(name, Long.toString(value));
    }

    Json with(String name, boolean value) {
        return member(name, Boolean.toString(value));
    }

    /** A number; {@code null} for one that JSON cannot write. */
    Json with(String name, double value) {
        return member(name, number(value));
    }

    Json with(String name, Vec3 value) {
        return member(name, "[" + number(value.x()) + "," + number(value.y()) + "," + number(value.z()) + "]");
    }

    Json with(String name, Json value) {
        return member(name, value.toString());
    }

    Json with(String name, Collection<Json> values) {
        return member(name, values.stream().map(Json::toString).collect(Collectors.joining(",", "[", "]")));
    }

    Json withTexts(String name, Collection<String> values) {
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
