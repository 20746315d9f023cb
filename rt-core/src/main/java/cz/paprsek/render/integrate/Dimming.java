package cz.paprsek.render.integrate;

import cz.paprsek.render.surface.Absorption;
import cz.paprsek.render.surface.Media;
import cz.paprsek.render.surface.World;
import cz.paprsek.shape.placed.Spans;
import java.util.function.IntPredicate;

/** What the substances along a way take of light. Scratch of one worker. */
final class Dimming {
    private final World scene;
    private final Media media = new Media();
    private int[] order = new int[16];
    private double depthRed;
    private double depthGreen;
    private double depthBlue;

    /** The share that is left of each channel. */
    double red;
    double green;
    double blue;

    /** Hears nothing. */
    static final Stretches UNTOLD = (object, length) -> {};

    /** Hears of each stretch within one substance. */
    interface Stretches {
        void through(int object, double length);
    }

    Dimming(World scene) {
        this.scene = scene;
    }

    /** Forgets the way so far. */
    void clear() {
        depthRed = 0;
        depthGreen = 0;
        depthBlue = 0;
    }

    /** Finds what is left after all that was gone. */
    void finish() {
        red = Absorption.left(depthRed);
        green = Absorption.left(depthGreen);
        blue = Absorption.left(depthBlue);
    }

    /** Goes some way inside an object, or outside of all if that is −1; whether anything is taken. */
    boolean go(int object, double way) {
        Absorption by = scene.absorption(object);
        if (by == null) {
            return false;
        }
        depthRed += Absorption.depth(by.red, way);
        depthGreen += Absorption.depth(by.green, way);
        depthBlue += Absorption.depth(by.blue, way);
        return true;
    }

    /**
     * Goes along a straight way; the result does not depend on the order in which its boundaries were found.
     *
     * @param boundaries those that were pushed from {@code mark} on
     * @param counts which of them are met
     * @param around the media where it starts
     * @param end its length, which may be infinite
     */
    void along(Spans boundaries, int mark, IntPredicate counts, Media around, double end, Stretches told) {
        int count = sort(boundaries, mark, counts);
        media.set(around);
        clear();
        double gone = 0;
        for (int i = 0; i <= count; i++) {
            double next = i < count ? Math.min(Math.max(boundaries.t(order[i]), gone), end) : end;
            if (next > gone && go(media.innermost(), next - gone)) {
                told.through(media.innermost(), next - gone);
            }
            gone = next;
            if (i < count) {
                cross(scene.parts().object(boundaries.part(order[i])));
            }
        }
        finish();
    }

    /** Of boundaries in one place that of the lower part comes first. By insertion: there are few. */
    private int sort(Spans boundaries, int mark, IntPredicate counts) {
        if (boundaries.size() - mark > order.length) {
            order = new int[2 * (boundaries.size() - mark)];
        }
        int count = 0;
        for (int i = mark; i < boundaries.size(); i++) {
            if (counts.test(i)) {
                int at = count++;
                for (; at > 0 && isBefore(boundaries, i, order[at - 1]); at--) {
                    order[at] = order[at - 1];
                }
                order[at] = i;
            }
        }
        return count;
    }

    private static boolean isBefore(Spans boundaries, int i, int j) {
        return boundaries.t(i) < boundaries.t(j) || (boundaries.t(i) == boundaries.t(j) && boundaries.part(i) < boundaries.part(j));
    }

    private void cross(int object) {
        if (!scene.isSolid(object)) {
            return;
        }
        if (media.hold(object)) {
            media.leave(object);
        } else {
            media.enter(object, 1);
        }
    }
}
