package cz.paprsek.drawing;

import cz.paprsek.math.Vec3;
import cz.paprsek.words.Words;
import java.util.Locale;

/** The world seen from far away along an axis. */
public enum Projection {
    FRONT, TOP, RIGHT;

    /** What it is called. */
    public String title(Words words) {
        return words.of("view." + name().toLowerCase(Locale.ROOT));
    }

    /** Where the view goes. */
    Vec3 along() {
        return switch (this) {
            case FRONT -> new Vec3(0, 0, -1);
            case TOP -> new Vec3(0, -1, 0);
            case RIGHT -> new Vec3(-1, 0, 0);
        };
    }

    /** To the right, in scene units. */
    public double right(Vec3 point) {
        return this == RIGHT ? -point.z() : point.x();
    }

    /** Upwards, in scene units. */
    public double up(Vec3 point) {
        return this == TOP ? -point.z() : point.y();
    }
}
