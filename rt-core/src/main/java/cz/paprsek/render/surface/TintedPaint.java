package cz.paprsek.render.surface;

import cz.paprsek.material.Pattern;
import cz.paprsek.shape.placed.Part;
import java.util.Objects;

/** A paint that colours of the surface itself lie over, such as those of the corners of a triangle: each channel is the product of both. */
final class TintedPaint extends Paint {
    private static final String KIND = "vertex-colors";

    private final Paint under;
    private final boolean isPlain;

    TintedPaint(Pattern pattern, Paint under) {
        super(pattern);
        this.under = under;
        this.isPlain = pattern instanceof Pattern.Plain;
    }

    /** It must know which part is hit. */
    @Override
    public boolean isPicture() {
        return true;
    }

    @Override
    boolean isTinted() {
        return true;
    }

    @Override
    public void color(Level level) {
        under.color(level);
        Part part = Objects.requireNonNull(level.part);
        part.tint(level.ray.face < 0 ? ~level.ray.face : level.ray.face, level.hit);
        level.colorRed *= level.hit.red;
        level.colorGreen *= level.hit.green;
        level.colorBlue *= level.hit.blue;
    }

    @Override
    Told tell(Level level, String of, String kind) {
        Told below = under.tell(level, of, kind);
        color(level);
        return new Told(of, isPlain ? KIND : below.pattern(), below.file(), below.u(), below.v(), below.column(), below.row(), below.pointRed(), below.pointGreen(), below.pointBlue(),
                level.colorRed, level.colorGreen, level.colorBlue);
    }

    @Override
    void slope(Level level) {
        under.slope(level);
    }
}
