package cz.paprsek.cli.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A reader of the YAML that most manifests are: maps and lists by indent, texts in double quotes, whole numbers, flags. Anything else is a fault. */
final class Manifest {
    private static final Pattern ESCAPED = Pattern.compile("\\\\(?:u(\\p{XDigit}{4})|([\"\\\\]))");

    private final List<String> lines;
    private int at;

    private Manifest(List<String> lines) {
        this.lines = new ArrayList<>(lines);
    }

    static List<Object> documents(String text) {
        List<Object> documents = new ArrayList<>();
        for (String document : text.split("(?m)^---\n", -1)) {
            Manifest manifest = new Manifest(document.lines().filter(line -> !line.startsWith("#")).toList());
            documents.add(manifest.node(0));
            if (manifest.at < manifest.lines.size()) {
                throw new IllegalArgumentException("not understood: " + manifest.lines.get(manifest.at));
            }
        }
        return documents;
    }

    private int indent() {
        return at == lines.size() ? -1 : lines.get(at).length() - lines.get(at).stripLeading().length();
    }

    private Object node(int indent) {
        return lines.get(at).startsWith("- ", indent) ? list(indent) : map(indent);
    }

    private Map<String, Object> map(int indent) {
        Map<String, Object> map = new LinkedHashMap<>();
        while (indent() == indent && !lines.get(at).startsWith("- ", indent)) {
            String line = lines.get(at++);
            int colon = line.indexOf(':');
            String key = line.substring(indent, colon);
            String rest = line.substring(colon + 1).strip();
            if (map.put(key, rest.isEmpty() ? node(indent()) : scalar(rest)) != null) {
                throw new IllegalArgumentException("twice: " + key);
            }
        }
        return map;
    }

    private List<Object> list(int indent) {
        List<Object> list = new ArrayList<>();
        while (indent() == indent && lines.get(at).startsWith("- ", indent)) {
            String item = lines.get(at).substring(indent + 2);
            if (item.matches("[\\w./-]+:.*")) {
                lines.set(at, " ".repeat(indent + 2) + item);
                list.add(map(indent + 2));
            } else {
                at++;
                list.add(scalar(item));
            }
        }
        return list;
    }

    private static Object scalar(String text) {
        if (text.matches("\"([^\"\\\\]|\\\\.)*\"")) {
            return ESCAPED.matcher(text.substring(1, text.length() - 1)).replaceAll(found ->
                    Matcher.quoteReplacement(found.group(1) == null ? found.group(2) : Character.toString(Integer.parseInt(found.group(1), 16))));
        }
        return text.equals("{}") ? Map.of() : text.matches("true|false") ? (Object) Boolean.valueOf(text) : (Object) Integer.valueOf(text);
    }
}
