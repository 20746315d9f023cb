package cz.paprsek.xml.write;

import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.text.Numbers;
import cz.paprsek.xml.format.SceneFormat;

/** Builds the text of an XML file: UTF-8, two blanks a level, an element a line. */
final class XmlText {
    private final StringBuilder text = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    private int level;
    /** Whether the last start tag still lacks its {@code >}. */
    private boolean tagIsOpen;

    XmlText open(String element) {
        Require.that(level < SceneFormat.DEEPEST, "the scene is nested deeper than the " + SceneFormat.DEEPEST + " levels that a file may have");
        endTag();
        indent().append('<').append(element);
        tagIsOpen = true;
        level++;
        return this;
    }

    /** Adds an attribute to the element just opened, unless its value is empty. */
    XmlText attribute(String name, String value) {
        return attribute(name, value, false);
    }

    /** @param isPlain whether nothing in the value needs to be escaped, for sure */
    XmlText attribute(String name, String value, boolean isPlain) {
        if (!value.isEmpty()) {
            text.append(' ').append(name).append("=\"");
            if (isPlain) {
                text.append(value);
            } else {
                escape(value, "&#10;");
            }
            text.append('"');
        }
        return this;
    }

    XmlText close(String element) {
        level--;
        if (tagIsOpen) {
            text.append("/>\n");
            tagIsOpen = false;
        } else {
            indent().append("</").append(element).append(">\n");
        }
        return this;
    }

    /** An element that holds nothing but text. */
    void element(String name, String content) {
        endTag();
        indent().append('<').append(name).append('>');
        escape(content, "\n");
        text.append("</").append(name).append(">\n");
    }

    /** A file's only element with all that is inside, each line of it an element, as one among others. */
    void piece(String file) {
        endTag();
        file.replaceFirst(" xmlns=\"" + SceneFormat.NAMESPACE + "\"", "").lines().skip(1).forEach(line -> indent().append(line).append('\n'));
    }

    /** How many elements are open. */
    int level() {
        return level;
    }

    /** How long the text is, when the start tag before what comes next is closed. */
    int end() {
        endTag();
        return text.length();
    }

    /** Once more the elements whose text is from an index to another, in as many elements. */
    void again(int from, int to) {
        endTag();
        text.append(text, from, to);
    }

    /** The shortest text that reads back as the same number, −0 included, which people are shown as 0. */
    static String text(double value) {
        return value == 0 && 1 / value < 0 ? "-0" : Numbers.text(value);
    }

    static String text(Vec3 v) {
        return text(v.x()) + " " + text(v.y()) + " " + text(v.z());
    }

    @Override
    public String toString() {
        return text.toString();
    }

    private void endTag() {
        if (tagIsOpen) {
            text.append(">\n");
            tagIsOpen = false;
        }
    }

    private StringBuilder indent() {
        return text.append("  ".repeat(level));
    }

    /** @param lineBreak how one is written: as it is, in an attribute it would be read as a blank */
    private void escape(String value, String lineBreak) {
        if (isPlain(value)) {
            text.append(value);
            return;
        }
        value.codePoints().forEach(c -> {
            switch (c) {
                case '<' -> text.append("&lt;");
                case '>' -> text.append("&gt;");
                case '&' -> text.append("&amp;");
                case '"' -> text.append("&quot;");
                case '\n' -> text.append(lineBreak);
                case '\r', '\t' -> text.append("&#").append(c).append(';');
                default -> {
                    Require.that(SceneFormat.isAllowed(c), "a text has the character " + String.format("U+%04X", c) + ", which no file can hold; remove it");
                    text.appendCodePoint(c);
                }
            }
        });
    }

    private static boolean isPlain(String value) {
        for (int i = 0; i < value.length(); i++) {
            char c = value.charAt(i);
            if (c < ' ' || c > '~' || c == '<' || c == '>' || c == '&' || c == '"') {
                return false;
            }
        }
        return true;
    }
}
