package cz.paprsek.xml.quick;

import cz.paprsek.scene.Scene.Sky;

/** The element {@code <sky>}: it has the attributes of a gradient, or those of a picture. */
final class SkyForm {
    static final byte[] ELEMENT = Slot.ascii("sky");

    private static final RecordForm<Sky.Gradient> GRADIENT = new RecordForm<>(Sky.Gradient.class);
    private static final RecordForm<Sky.Picture> PICTURE = new RecordForm<>(Sky.Picture.class);
    static final TagForm TAG = new TagForm(GRADIENT.slots(), PICTURE.slots().stream().map(slot -> slot.isRequired() ? slot.unlessGiven() : slot).toList());

    private SkyForm() {}

    /** Makes the sky of the values of its tag. */
    static Sky sky(Object[] values) {
        int at = GRADIENT.slots().size();
        if (PICTURE.isUntouched(values, at)) {
            return GRADIENT.make(values, 0);
        }
        Unusual.unless(GRADIENT.isUntouched(values, 0) && values[at] != Slot.NONE);
        return PICTURE.make(values, at);
    }
}
