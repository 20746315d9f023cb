package cz.paprsek.xml.text;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The text of a well-formed file in UTF-8, and where in it elements and attributes stand. Nothing is kept but the text. */
public final class Source {
    private final byte[] text;
    /** Files have many elements of a kind. */
    private String latestName = "";
    private final Element root;

    /** Where an attribute stands: its name, and its value without the quotes. */
    public record Attribute(String name, int start, int valueFrom, int valueTo) {
        /** Behind the closing quote. */
        public int end() {
            return valueTo + 1;
        }
    }

    /** Where a prefix stands, its colon included. */
    record Prefix(int from, int to) {}

    public Source(byte[] text) {
        this.text = text;
        int at = nextToken(0);
        while (!isStartTag(at)) {
            at = nextToken(tokenEnd(at));
        }
        root = element(at);
    }

    byte[] bytes() {
        return text;
    }

    public String text(int from, int to) {
        return new String(text, from, to - from, StandardCharsets.UTF_8);
    }

    /** The outermost element. */
    public Element root() {
        return root;
    }

    /** Where the first element inside the outermost one begins; where that ends if there is none. */
    int firstChild() {
        int at = nextToken(root.inside());
        while (at < root.insideTo() && !isStartTag(at)) {
            at = nextToken(tokenEnd(at));
        }
        return Math.min(at, root.insideTo());
    }

    /** The elements directly inside another one. */
    public List<Element> children(Element parent) {
        List<Element> children = new ArrayList<>();
        int at = nextToken(parent.inside());
        while (at < parent.insideTo()) {
            int end = tokenEnd(at);
            if (isStartTag(at)) {
                Element child = element(at);
                children.add(child);
                end = child.end();
            }
            at = nextToken(end);
        }
        return children;
    }

    /** Where the first thing begins that is no XML declaration. */
    int firstBehindDeclaration() {
        int at = nextToken(0);
        return has("<?xml", at) && isBlank(text[at + 5]) ? nextToken(tokenEnd(at)) : at;
    }

    /** What an element says that prefixes stand for, the colon included; the empty one stands for itself. */
    public Map<String, String> declarations(Element element) {
        Map<String, String> declared = new LinkedHashMap<>();
        for (Attribute attribute : attributes(element)) {
            if (attribute.name().equals("xmlns") || attribute.name().startsWith("xmlns:")) {
                String prefix = attribute.name().equals("xmlns") ? "" : attribute.name().substring("xmlns:".length()) + ":";
                declared.put(prefix, text(attribute.valueFrom(), attribute.valueTo()));
            }
        }
        return declared;
    }

    /** Where the prefixes of all tags stand, which may be empty ones. */
    List<Prefix> prefixes() {
        List<Prefix> prefixes = new ArrayList<>();
        for (int at = nextToken(0); at < text.length; at = nextToken(tokenEnd(at))) {
            if (text[at + 1] != '!' && text[at + 1] != '?') {
                int from = at + (text[at + 1] == '/' ? 2 : 1);
                prefixes.add(new Prefix(from, localName(from)));
            }
        }
        return prefixes;
    }

    /** Whether a start tag of such an element begins here, whatever its prefix. */
    boolean isNamed(String name, int at) {
        return text[at + 1] != '/' && has(name, localName(at + 1)) && text[tagEnd(at) - 2] != '/';
    }

    /** Where a name begins behind its prefix. */
    private int localName(int from) {
        int local = from;
        for (int at = from; !isBlank(text[at]) && text[at] != '>' && text[at] != '/'; at++) {
            local = text[at] == ':' ? at + 1 : local;
        }
        return local;
    }

    boolean contains(String ascii) {
        for (int at = 0; at < text.length; at++) {
            if (has(ascii, at)) {
                return true;
            }
        }
        return false;
    }

    public List<Attribute> attributes(Element element) {
        List<Attribute> attributes = new ArrayList<>();
        int at = skipBlanks(element.nameTo());
        while (text[at] != '>' && text[at] != '/') {
            int start = at;
            while (!isBlank(text[at]) && text[at] != '=') {
                at++;
            }
            String name = text(start, at);
            int quote = skipBlanks(skipBlanks(at) + 1);
            int close = indexOf(text[quote], quote + 1);
            attributes.add(new Attribute(name, start, quote + 1, close));
            at = skipBlanks(close + 1);
        }
        return attributes;
    }

    /** The prefix of its name, the colon included; empty if it has none. */
    public String prefix(Element element) {
        return text(element.start() + 1, element.nameFrom());
    }

    /** Whether this stands here. */
    boolean has(String ascii, int at) {
        if (at < 0 || at + ascii.length() > text.length) {
            return false;
        }
        for (int i = 0; i < ascii.length(); i++) {
            if (text[at + i] != ascii.charAt(i)) {
                return false;
            }
        }
        return true;
    }

    /** Where the tag, comment, instruction or section of plain text ends that begins here. */
    int tokenEnd(int at) {
        if (has("<!--", at)) {
            return indexOf("-->", at + 4) + 3;
        }
        if (has("<![CDATA[", at)) {
            return indexOf("]]>", at + 9) + 3;
        }
        return has("<?", at) ? indexOf("?>", at + 2) + 2 : tagEnd(at);
    }

    private Element element(int start) {
        int nameFrom = localName(start + 1);
        int nameTo = nameFrom;
        while (!isBlank(text[nameTo]) && text[nameTo] != '>' && text[nameTo] != '/') {
            nameTo++;
        }
        int inside = tagEnd(start);
        if (text[inside - 2] == '/') {
            return new Element(name(nameFrom, nameTo), start, nameFrom, inside, inside, inside);
        }
        int at = nextToken(inside);
        for (int depth = 1; ; at = nextToken(tokenEnd(at))) {
            if (has("</", at)) {
                depth--;
            } else if (isStartTag(at) && text[tagEnd(at) - 2] != '/') {
                depth++;
            }
            if (depth == 0) {
                return new Element(name(nameFrom, nameTo), start, nameFrom, inside, at, tagEnd(at));
            }
        }
    }

    private String name(int from, int to) {
        if (to - from != latestName.length() || !has(latestName, from)) {
            latestName = text(from, to);
        }
        return latestName;
    }

    private boolean isStartTag(int at) {
        if (at == text.length) {
            throw new Unpatchable("an element has no end");
        }
        return text[at + 1] != '/' && text[at + 1] != '!' && text[at + 1] != '?';
    }

    /** The next {@code <}; the end of the text if there is none. */
    int nextToken(int from) {
        int at = from;
        while (at < text.length && text[at] != '<') {
            at++;
        }
        return at;
    }

    private int tagEnd(int start) {
        int at = start;
        while (text[at] != '>') {
            at = text[at] == '"' || text[at] == '\'' ? indexOf(text[at], at + 1) + 1 : at + 1;
        }
        return at + 1;
    }

    int indexOf(byte wanted, int from) {
        int at = from;
        while (text[at] != wanted) {
            at++;
        }
        return at;
    }

    private int indexOf(String wanted, int from) {
        int at = from;
        while (!has(wanted, at)) {
            at = indexOf((byte) wanted.charAt(0), at + 1);
        }
        return at;
    }

    private int skipBlanks(int from) {
        int at = from;
        while (isBlank(text[at])) {
            at++;
        }
        return at;
    }

    static boolean isBlank(byte c) {
        return c == ' ' || c == '\t' || c == '\n' || c == '\r';
    }

    @Override
    public String toString() {
        return new String(Arrays.copyOf(text, Math.min(text.length, 200)), StandardCharsets.UTF_8);
    }
}
