package cz.paprsek.xml.format;

/** Builds the text of a schema: a line for every tag, two blanks a level. */
final class SchemaText {
    private final StringBuilder text = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    private int level;

    /** @param attributes names and values in turn */
    SchemaText open(String element, String... attributes) {
        tag(element, attributes).append(">\n");
        level++;
        return this;
    }

    /** An element with nothing inside. */
    SchemaText leaf(String element, String... attributes) {
        tag(element, attributes).append("/>\n");
        return this;
    }

    SchemaText close(String element) {
        level--;
        text.append("  ".repeat(level)).append("</xs:").append(element).append(">\n");
        return this;
    }

    SchemaText documentation(String sentence) {
        text.append("  ".repeat(level)).append("<xs:annotation><xs:documentation>").append(escaped(sentence)).append("</xs:documentation></xs:annotation>\n");
        return this;
    }

    private StringBuilder tag(String element, String... attributes) {
        text.append("  ".repeat(level)).append("<xs:").append(element);
        for (int i = 0; i < attributes.length; i += 2) {
            text.append(' ').append(attributes[i]).append("=\"").append(escaped(attributes[i + 1])).append('"');
        }
        return text;
    }

    private static String escaped(String value) {
        return value.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
