package cz.paprsek.xml.quick;

import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Reads {@code <material>}, which stands in a scene with a name, and without one in an object. */
final class MaterialReader {
    static final byte[] ELEMENT = Slot.ascii("material");

    private static final RecordForm<Material> MATERIAL = new RecordForm<>(Material.class);
    private static final List<Slot> OWN = List.of(Slot.optional("name", ValueForm.TEXT, Slot.NONE), Slot.optional("color", ValueForm.COLOR, Slot.NONE));
    private static final TagForm TAG = new TagForm(OWN, MATERIAL.slots());

    private final Markup markup;
    private final double[] room;

    /** @param room for three numbers */
    MaterialReader(Markup markup, double[] room) {
        this.markup = markup;
        this.room = room;
    }

    /** A material with its name, which is empty if it has none. */
    record Named(String name, Material material) {}

    /** The material whose start tag is at hand. */
    Named read(int depth) throws IOException {
        Object[] values = TAG.read(markup, room);
        Pattern pattern = null;
        if (markup.hasContent(depth)) {
            while (markup.nextTag()) {
                Unusual.unless(pattern == null);
                pattern = pattern(depth + 1);
            }
            markup.endTag(ELEMENT);
        }
        return new Named((String) values[0], MATERIAL.make(values, OWN.size(), pattern(values[1], pattern)));
    }

    private static Pattern pattern(Object color, @Nullable Pattern inside) {
        Unusual.unless(inside == null || color == Slot.NONE);
        return inside != null ? inside : color instanceof Rgb plain ? new Pattern.Plain(plain) : Material.DEFAULT.pattern();
    }

    private Pattern pattern(int depth) throws IOException {
        for (PatternForm form : PatternForm.ALL) {
            if (form.name().isAtHand(markup)) {
                Object[] values = form.tag().read(markup, room);
                return form.make(values, stops(form, depth));
            }
        }
        throw new Unusual();
    }

    private List<Pattern.Stop> stops(PatternForm form, int depth) throws IOException {
        List<Pattern.Stop> stops = new ArrayList<>();
        if (markup.hasContent(depth)) {
            while (markup.nextTag()) {
                Unusual.unless(markup.isNamed(PatternForm.STOP) && stops.size() < Pattern.Stops.MOST);
                Object[] values = PatternForm.STOP_TAG.read(markup, room);
                markup.noContent(PatternForm.STOP, depth + 1);
                stops.add(PatternForm.STOPS.make(values, 0));
            }
            form.name().end(markup);
        }
        return stops;
    }
}
