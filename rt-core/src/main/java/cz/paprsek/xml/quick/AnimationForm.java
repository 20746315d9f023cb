package cz.paprsek.xml.quick;

import cz.paprsek.attribute.Described;
import cz.paprsek.scene.Animation;
import cz.paprsek.xml.format.ColorWords;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** The element {@code <animate>}, with its keys inside. */
final class AnimationForm {
    static final byte[] ELEMENT = Slot.ascii("animate");

    private static final byte[] KEY = Slot.ascii("key");
    private static final RecordForm<Animation> FORM = new RecordForm<>(Animation.class);
    private static final TagForm TAG = new TagForm(FORM.slots(), List.of());
    private static final RecordForm<Animation.Key> KEYS = new RecordForm<>(Animation.Key.class);
    private static final TagForm KEY_TAG = new TagForm(KEYS.slots(), List.of());
    private static final int VALUE = Described.of(Animation.Key.class).stream().map(Described::name).toList().indexOf("value");

    private AnimationForm() {}

    /** The animation whose start tag is at hand. */
    static Animation read(Markup markup, double[] room, int depth) throws IOException {
        Object[] values = TAG.read(markup, room);
        List<Animation.Key> keys = new ArrayList<>();
        if (markup.hasContent(depth)) {
            while (markup.nextTag()) {
                Unusual.unless(markup.isNamed(KEY));
                Object[] key = KEY_TAG.read(markup, room);
                markup.noContent(KEY, depth + 1);
                key[VALUE] = ColorWords.asNumbers((String) key[VALUE]);
                keys.add(KEYS.make(key, 0));
            }
            markup.endTag(ELEMENT);
        }
        return FORM.make(values, 0, keys);
    }
}
