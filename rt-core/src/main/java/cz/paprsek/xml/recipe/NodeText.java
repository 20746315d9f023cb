package cz.paprsek.xml.recipe;

import cz.paprsek.xml.format.SceneFormat;
import cz.paprsek.xml.recipe.Node.Attr;

/** The text of a file for a scene with formulas: an element a line, all as it is written, and nothing besides. */
final class NodeText {
    private final StringBuilder text = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");

    private NodeText() {}

    static String of(Node scene) {
        NodeText all = new NodeText();
        all.add(scene, 0);
        return all.text.toString();
    }

    private void add(Node node, int level) {
        text.append("  ".repeat(level)).append('<').append(node.name());
        if (level == 0) {
            text.append(" xmlns=\"").append(SceneFormat.NAMESPACE).append('"');
        }
        for (Attr one : node.attributes()) {
            text.append(' ').append(one.name()).append("=\"").append(Raw.of(one.text())).append('"');
        }
        if (node.children().isEmpty() && node.content().isEmpty()) {
            text.append("/>\n");
            return;
        }
        text.append('>');
        if (node.children().isEmpty()) {
            text.append(node.content().replace("\r", "&#13;").replace("\n", "&#10;"));
        } else {
            text.append('\n');
            node.children().forEach(child -> add(child, level + 1));
            text.append("  ".repeat(level));
        }
        text.append("</").append(node.name()).append(">\n");
    }
}
