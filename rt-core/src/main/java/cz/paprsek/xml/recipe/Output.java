package cz.paprsek.xml.recipe;

import cz.paprsek.xml.format.SceneFormat;
import cz.paprsek.xml.recipe.Node.Attr;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;

/** The text of what is written out: a start tag a line, of each of which is known what it stems from. */
final class Output {
    private final StringBuilder text = new StringBuilder();
    private Node[] lines = new Node[64];
    private Node[] owners = new Node[64];
    private Node[] sites = new Node[64];
    private final IdentityHashMap<Node, Integer> counts = new IdentityHashMap<>();
    private final List<Mark> marks = new ArrayList<>();
    private int count;
    private int level;
    private boolean tagIsOpen;

    /**
     * A value that has been worked out.
     *
     * @param line from 0
     * @param raw as it is written out
     */
    record Mark(int line, Attr attribute, String raw) {}

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
     * @param site the element of the file that it stands for outside of definitions
     */
    void open(String element, Node from, Node owner, Node site) {
        endTag();
        if (count == lines.length) {
            lines = Arrays.copyOf(lines, count * 2);
            owners = Arrays.copyOf(owners, count * 2);
            sites = Arrays.copyOf(sites, count * 2);
        }
        owners[count] = owner;
        sites[count] = site;
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

    /** As the other, of an attribute of the file. */
    void attribute(Attr given, String raw) {
        if (given.template().isPresent()) {
            marks.add(new Mark(count - 1, given, raw));
        }
        attribute(given.name(), raw);
    }

    /** What has been worked out. */
    List<Mark> marks() {
        return marks;
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

    /** Notes how often something is repeated; the first time counts. */
    void counted(Node repeat, int copies) {
        counts.putIfAbsent(repeat, copies);
    }

    int count(Node repeat) {
        return counts.getOrDefault(repeat, 0);
    }

    /** By line, from 0: what it stands for outside of definitions. */
    Node[] sites() {
        return Arrays.copyOf(sites, count);
    }

    /** By line, from 0: what it is there for. */
    Node[] owners() {
        return Arrays.copyOf(owners, count);
    }
}
