package cz.paprsek.render.integrate;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.sample.Place;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.Surroundings;
import cz.paprsek.render.surface.World;

/** Starts the rays from the eye, each in what is around there: scratch of one worker. */
final class CameraRays {
    private final Sampling sampling;
    private final Sampler sampler;
    private final Surroundings surroundings;
    private final Place place = new Place();

    CameraRays(World scene, Sampling sampling, Sampler sampler) {
        this.sampling = sampling;
        this.sampler = sampler;
        this.surroundings = new Surroundings(scene);
    }

    /** Makes ready for rays of an eye. */
    void from(Eye eye) {
        surroundings.from(eye.origins());
    }

    /** Starts a sample's ray from the eye, in what is around there; false if it is blind. */
    boolean start(Level level, Eye eye, int column, int row, int sample) {
        sampling.place(sampler, column, row, sample, place);
        level.isNegative = place.isNegative;
        double x = column + place.x;
        double y = row + place.y;
        if (!eye.hasAperture()) {
            return start(level, eye, x, y);
        }
        sampler.start(column, row, sample);
        sampler.lens();
        sampler.next();
        return entered(eye.start(level.ray, x, y, sampler.u, sampler.v), level);
    }

    /** Starts the ray through a point of the picture and the middle of the lens; false if it is blind. */
    boolean start(Level level, Eye eye, double x, double y) {
        return entered(eye.start(level.ray, x, y), level);
    }

    /** Starts a ray anywhere, in a direction of length 1. */
    void start(Level level, Vec3 origin, Vec3 direction) {
        level.ray.start(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
        surroundings.from(Bounds.ALL);
        surroundings.enter(level.ray, level.media);
    }

    private boolean entered(boolean sees, Level level) {
        if (sees) {
            surroundings.enter(level.ray, level.media);
        }
        return sees;
    }
}
