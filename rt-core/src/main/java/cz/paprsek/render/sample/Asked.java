package cz.paprsek.render.sample;

import java.util.stream.Stream;

/**
 * Scratch: what was last asked at one place of a path for the same purpose, and where a {@link Sampler}'s points of it are. Most paths of a pixel go alike, and ask the same there: then
 * neither the dimension is to be made nor looked for. Used with one sampler only.
 */
public final class Asked {
    private int path;
    private int lamp;
    /** The plan of points for which that is true. */
    private int plan = -1;
    int entry;
    int lane;

    /** @param count how many */
    public static Asked[] none(int count) {
        return Stream.generate(Asked::new).limit(count).toArray(Asked[]::new);
    }

    boolean is(int ofPath, int ofLamp, int ofPlan) {
        return plan == ofPlan && path == ofPath && lamp == ofLamp;
    }

    void note(int ofPath, int ofLamp, int ofPlan) {
        path = ofPath;
        lamp = ofLamp;
        plan = ofPlan;
    }
}
