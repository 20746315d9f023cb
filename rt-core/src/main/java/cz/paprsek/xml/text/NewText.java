package cz.paprsek.xml.text;

import java.util.Optional;

/** Writes what is new in a text, laid out as the rest of it. */
final class NewText {
    private final Layout layout;
    private final Removed removed;
    private final Moving moving;

    /** Gives the text of an element that has been moved and perhaps changed. */
    interface Moving {
        String text(Element element, Form old, Form now);
    }

    NewText(Layout layout, Removed removed, Moving moving) {
        this.layout = layout;
        this.removed = removed;
        this.moving = moving;
    }

    /**
     * An element without the blanks before it.
     *
     * @param prefix with its colon; or empty
     * @param scene where the scene begins that it is in
     */
    String of(Form form, String prefix, String indent, int scene) {
        StringBuilder out = new StringBuilder();
        write(out, form, prefix, indent, scene);
        return out.toString();
    }

    private void write(StringBuilder out, Form form, String prefix, String indent, int scene) {
        if (form.excerpt().isPresent()) {
            out.append(form.excerpt().get().within(prefix, indent, layout.lineBreak()));
            return;
        }
        Optional<Removed.Piece> moved = removed.moved(form, scene);
        if (moved.isPresent()) {
            out.append(moving.text(moved.get().element(), moved.get().form(), form));
            return;
        }
        Form.Body body = form.body();
        out.append('<').append(prefix).append(body.name());
        body.attributes().forEach((name, value) -> out.append(' ').append(name).append("=\"").append(value).append('"'));
        if (body.children().isEmpty() && body.content().isEmpty()) {
            out.append("/>");
            return;
        }
        out.append('>').append(body.content().replace("\n", layout.lineBreak()));
        for (Form child : body.children()) {
            out.append(layout.lineBreak()).append(indent).append(layout.unit());
            write(out, child, prefix, indent + layout.unit(), scene);
        }
        if (!body.children().isEmpty()) {
            out.append(layout.lineBreak()).append(indent);
        }
        out.append("</").append(prefix).append(body.name()).append('>');
    }

    /** What stands for itself in a section of plain text. */
    static String plain(String content) {
        return content.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&");
    }
}
