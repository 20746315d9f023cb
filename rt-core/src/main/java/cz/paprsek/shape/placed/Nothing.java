package cz.paprsek.shape.placed;

import cz.paprsek.math.Bounds;

/** What is left of a body that is hidden. */
public final class Nothing extends Volume {
    public static final Nothing NOTHING = new Nothing();

    private Nothing() {}

    @Override
    public Bounds bounds() {
        return Bounds.EMPTY;
    }

    @Override
    public void spans(Ray ray, Spans out) {
        // No ray meets it.
    }
}
