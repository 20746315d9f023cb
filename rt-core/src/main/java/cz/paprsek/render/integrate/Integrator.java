package cz.paprsek.render.integrate;

import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import java.util.function.BooleanSupplier;

/** How the light of pixels is gathered: scratch of one worker, with its formulas. What a pixel gets depends on nothing but the scene and the pixel. */
public interface Integrator {
    /** Begins another picture of the same scene: nothing is counted yet, nothing cancelled. */
    void begin(BooleanSupplier stop);

    /** Renders a block of pixels; if it is {@linkplain #isCancelled cancelled} meanwhile, what is on the film does not count. */
    void block(Eye eye, int x, int y, int width, int height, Film film);

    /** Whether it was told to stop. */
    boolean isCancelled();

    /** Rays of all kinds traced so far. */
    long rays();

    /** What was done so far. */
    Work work();

    /** Numbers of rays by kind, and how many of those that are no shadow rays hit something. */
    record Work(long primary, long reflected, long refracted, long shadows, long hits) {}
}
