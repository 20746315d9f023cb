package cz.paprsek.render.integrate;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.eye.Views;
import cz.paprsek.render.sample.Place;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.Surroundings;
import cz.paprsek.render.surface.World;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;

/** Starts the rays from the eye, each in what is around there: scratch of one worker. */
final class CameraRays {
    private final Sampling sampling;
    private final Sampler sampler;
    private final Surroundings surroundings;
    private final Place place = new Place();
    private final boolean footprints;
    /** How far rays are apart, in pixels. */
    private final double spacing;
    private final Ray beside = new Ray(new Spans());
    /** Of a block. */
    private final Views views = new Views();

    CameraRays(World scene, Sampling sampling, Sampler sampler) {
        this.sampling = sampling;
        this.sampler = sampler;
        this.surroundings = new Surroundings(scene);
        this.footprints = scene.asksForFootprints();
        this.spacing = 1 / Math.sqrt(sampling.rays());
    }

    /** Makes ready for rays of an eye. */
    void from(Eye eye) {
        surroundings.from(eye.origins());
    }

    /**
     * Makes ready so many rays for each pixel of a block.
     *
     * @return whether they are aimed only, all at once, and yet to be started one by one; else they are started, each in what is around there, and may be blind
     */
    boolean aim(Level[] rays, Eye eye, int x, int y, int width, int height, int sample, int perPixel) {
        boolean atOnce = eye.looksFromOnePlace() && !footprints;
        if (atOnce) {
            views.reserve(width * height * perPixel);
        }
        int i = 0;
        for (int row = y; row < y + height; row++) {
            for (int column = x; column < x + width; column++) {
                for (int k = 0; k < perPixel; k++) {
                    if (atOnce) {
                        sampling.place(sampler, column, row, sample + k, place);
                        rays[i].isNegative = place.isNegative;
                        views.x[i] = column + place.x;
                        views.y[i] = row + place.y;
                    } else {
                        start(rays[i], eye, column, row, sample + k);
                    }
                    i++;
                }
            }
        }
        if (atOnce) {
            eye.look(views, i);
        }
        return atOnce;
    }

    /** Starts one of those that are only aimed. */
    void start(Level level, Eye eye, int i) {
        eye.start(level.ray, views, i);
        surroundings.enter(level.ray, level.media);
    }

    /** Starts a sample's ray from the eye, in what is around there; it may be blind. */
    void start(Level level, Eye eye, int column, int row, int sample) {
        sampling.place(sampler, column, row, sample, place);
        level.isNegative = place.isNegative;
        double x = column + place.x;
        double y = row + place.y;
        if (!eye.hasAperture()) {
            start(level, eye, x, y);
            return;
        }
        look(level, eye, x, y);
        sampler.start(column, row, sample);
        sampler.lens();
        sampler.next();
        if (eye.start(level.ray, x, y, sampler.u, sampler.v)) {
            surroundings.enter(level.ray, level.media);
        }
    }

    /** Starts the ray through a point of the picture and the middle of the lens; it may be blind. */
    void start(Level level, Eye eye, double x, double y) {
        look(level, eye, x, y);
        if (eye.start(level.ray, x, y)) {
            surroundings.enter(level.ray, level.media);
        }
    }

    /** Starts a ray anywhere, in a direction of length 1. */
    void start(Level level, Vec3 origin, Vec3 direction) {
        level.footprint.startAlike(0);
        level.footprint.startAlike(1);
        level.ray.start(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
        surroundings.from(Bounds.ALL);
        surroundings.enter(level.ray, level.media);
    }

    /** Sets how far the ray's neighbours are: as far as rays of a pixel are from each other, through the middle of the lens. */
    private void look(Level level, Eye eye, double x, double y) {
        if (footprints) {
            boolean sees = eye.start(level.ray, x, y);
            set(0, sees && eye.start(beside, x + spacing, y), level);
            set(1, sees && eye.start(beside, x, y + spacing), level);
        }
    }

    private void set(int neighbour, boolean sees, Level level) {
        if (sees) {
            level.footprint.start(neighbour, level.ray, beside);
        } else {
            level.footprint.startAlike(neighbour);
        }
    }
}
