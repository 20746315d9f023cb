package cz.paprsek.render.show;

import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.integrate.Whitted;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import java.util.Optional;

/** The tracer that renders pictures, watched for what a mode other than shaded shows of each pixel. */
public final class ModeTracer extends Whitted {
    private final RenderMode mode;
    /** How a number of each pixel is shown, if that is what the mode shows. */
    private final Optional<Heat> heat;
    private final Sight sight;

    public ModeTracer(World scene, RenderMode mode, int maxDepth, Sampling sampling, DepthRange range, boolean numbers) {
        this(scene, mode, maxDepth, sampling, new Sight(scene, mode, range, numbers));
    }

    private ModeTracer(World scene, RenderMode mode, int maxDepth, Sampling sampling, Sight sight) {
        super(scene, mode.scale().isPresent() ? maxDepth : 1, sampling, sight);
        this.mode = mode;
        this.sight = sight;
        heat = mode.scale().map(scale -> Heat.of(mode, sight.numbers));
    }

    @Override
    public void block(Eye eye, int x, int y, int width, int height, Film film) {
        for (int i = 0; i < width * height && !isCancelled(); i++) {
            if (heat.isPresent()) {
                heat.get().show(counted(eye, x + i % width, y + i / width), x + i % width, y + i / width, film);
            } else {
                Level shown = shown(eye, x + i % width, y + i / width);
                film.set(x + i % width, y + i / width, shown.red, shown.green, shown.blue);
            }
        }
    }

    private double counted(Eye eye, int x, int y) {
        forget();
        long rays = rays();
        long nodes = nodeVisits();
        int samples = eachAlone(eye, x, y);
        return switch (mode) {
            case ERROR -> interval();
            case SAMPLES -> samples;
            case RAYS -> rays() - rays;
            default -> nodeVisits() - nodes;
        };
    }

    /** Renders a pixel; the colour is in the level returned. */
    private Level shown(Eye eye, int x, int y) {
        sight.clear();
        sight.show(eachAlone(eye, x, y), alone());
        return alone();
    }

    @Override
    protected void tracedAlone() {
        sight.endRay();
    }
}
