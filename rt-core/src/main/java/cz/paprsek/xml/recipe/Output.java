package cz.paprsek.xml.recipe;

import cz.paprsek.xml.format.SceneFormat;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** The text of what is written out: a start tag a line, of each of which is known what it stems from. */
final class Output {
    private final StringBuilder text = new StringBuilder();
    private Node[] lines = new Node[64];
    private Node[] owners = new Node[64];
    private int count;
    private int level;
    private boolean tagIsOpen;

    /** Where nesting has become deeper than files may have it. */
    boolean isTooDeep() {
        return level >= SceneFormat.DEEPEST;
    }

    int length() {
        return text.length();
    }

    /**
     * Begins an element on a line of its own.
     *
     * @param owner the element of the file, inside that from which the element around stems, that it is there for
     */
    void open(String element, Node from, Node owner) {
        endTag();
        if (count == lines.length) {
            lines = Arrays.copyOf(lines, count * 2);
            owners = Arrays.copyOf(owners, count * 2);
        }
        owners[count] = owner;
        if (count > 0) {
            text.append('\n');
        }
        lines[count++] = from;
        text.append('<').append(element);
        tagIsOpen = true;
        level++;
    }

    /** @param raw as it may stand between quotes */
    void attribute(String name, String raw) {
        text.append(' ').append(name).append("=\"").append(raw.indexOf('"') < 0 ? raw : raw.replace("\"", "&quot;")).append('"');
    }

    /** @param raw as it may stand between tags */
    void content(String raw) {
        if (!raw.isEmpty()) {
            endTag();
            text.append(raw.replace("\r", "&#13;").replace("\n", "&#10;"));
        }
    }

    void close(String element) {
        level--;
        text.append(tagIsOpen ? "/>" : "</" + element + ">");
        tagIsOpen = false;
    }

    private void endTag() {
        if (tagIsOpen) {
            text.append('>');
            tagIsOpen = false;
        }
    }

    String text() {
        return text.toString();
    }

    byte[] bytes() {
        return text.toString().getBytes(StandardCharsets.UTF_8);
    }

    /** By line, from 0: what it stems from. */
    Node[] lines() {
        return Arrays.copyOf(lines, count);
    }

    /** By line, from 0: what it is there for. */
    Node[] owners() {
        return Arrays.copyOf(owners, count);
    }
}
