package cz.paprsek.cli.plan;

import java.util.List;
import java.util.Map;

/** YAML of maps, lists, texts, whole numbers and flags: each member on a line of its own, texts in quotes as in JSON, which every reader takes for the same. */
final class Yaml {
    private Yaml() {}

    /** A document. */
    static String of(Map<String, ?> document) {
        StringBuilder text = new StringBuilder();
        map(document, 0, text);
        return text.toString();
    }

    private static void map(Map<String, ?> map, int indent, StringBuilder text) {
        map.forEach((key, value) -> {
            text.append(" ".repeat(indent)).append(key).append(':');
            value(value, indent, text);
        });
    }

    private static void value(Object value, int indent, StringBuilder text) {
        if (value instanceof Map<?, ?> map && !map.isEmpty()) {
            text.append('\n');
            map(members(map), indent + 2, text);
        } else if (value instanceof List<?> list && !list.isEmpty()) {
            text.append('\n');
            list.forEach(item -> item(item, indent + 2, text));
        } else {
            text.append(' ').append(scalar(value)).append('\n');
        }
    }

    private static void item(Object item, int indent, StringBuilder text) {
        text.append(" ".repeat(indent)).append("- ");
        if (item instanceof Map<?, ?> map) {
            StringBuilder members = new StringBuilder();
            map(members(map), indent + 2, members);
            text.append(members.substring(indent + 2));
        } else {
            text.append(scalar(item)).append('\n');
        }
    }

    @SuppressWarnings("unchecked")
    private static Map<String, ?> members(Map<?, ?> map) {
        return (Map<String, ?>) map;
    }

    private static String scalar(Object value) {
        if (value instanceof Map<?, ?>) {
            return "{}";
        }
        if (value instanceof List<?>) {
            return "[]";
        }
        return value instanceof Number || value instanceof Boolean ? value.toString() : quoted(value.toString());
    }

    private static String quoted(String text) {
        StringBuilder quoted = new StringBuilder("\"");
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            quoted.append(c == '"' || c == '\\' ? "\\" + c : c < ' ' || c > '~' ? String.format("\\u%04x", (int) c) : Character.toString(c));
        }
        return quoted.append('"').toString();
    }
}
