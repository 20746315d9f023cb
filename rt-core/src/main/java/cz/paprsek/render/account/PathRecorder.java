package cz.paprsek.render.account;

import cz.paprsek.ray.Arrival;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.integrate.Paths;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/** The tracer of paths, writing down what it does as trees of rays, each of one branch. */
final class PathRecorder extends Paths {
    private final RayBook book;

    /** @param stop whether to give up, which throws a {@link CancellationException} */
    PathRecorder(World scene, int maxDepth, Passes sampling, BooleanSupplier stop) {
        super(scene, maxDepth, sampling);
        // What the last ray meets still shines.
        book = new RayBook(scene, maxDepth + 1, this::map, stop);
    }

    /** Traces rays from an eye from now on. */
    void lookThrough(Eye from) {
        book.lookThrough(from);
    }

    /** The rays from the eye traced so far. */
    List<TracedRay> trees() {
        return book.trees();
    }

    @Override
    public boolean hearsAll() {
        return true;
    }

    @Override
    public void following(boolean refracted, double red, double green, double blue) {
        book.following(refracted, red, green, blue);
    }

    @Override
    public void missed(Level level) {
        book.missed(level);
    }

    @Override
    public void met(Level level) {
        book.met(level);
    }

    @Override
    public void seen(Level level, int lamp) {
        book.seen(level, lamp);
    }

    @Override
    public void sought(int lamp, Arrival arrival, double facing, double visibility) {
        book.sought(lamp, arrival, facing, visibility);
    }

    @Override
    public void dimmed(double red, double green, double blue) {
        book.dimmed(red, green, blue);
    }

    @Override
    public void strewn(double spread, double seen, double lit, double red, double green, double blue) {
        book.strewn(spread, seen, lit, red, green, blue);
    }

    @Override
    public void illuminated(double diffuse, double highlight, double red, double green, double blue) {
        book.illuminated(diffuse, highlight, red, green, blue);
    }

    @Override
    public void averaged(int lamp, double red, double green, double blue) {
        book.averaged(lamp, red, green, blue);
    }

    @Override
    public void bent(double from, double to, double cosine, double radicand) {
        book.bent(from, to, cosine, radicand);
    }

    @Override
    public void split(double from, double to, double cosine, double beyond, double red, double green, double blue) {
        book.split(from, to, cosine, beyond, red, green, blue);
    }

    @Override
    public void facet(double x, double y, double z, double chance, double seen) {
        book.facet(x, y, z, chance, seen);
    }

    @Override
    public void emitted(double red, double green, double blue) {
        book.emitted(red, green, blue);
    }

    @Override
    public void absorbed(int object, double length, double red, double green, double blue) {
        book.absorbed(object, length, red, green, blue);
    }

    @Override
    public void ended(Level level) {
        book.ended(level);
    }
}
