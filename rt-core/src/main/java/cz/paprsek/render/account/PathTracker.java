package cz.paprsek.render.account;

import cz.paprsek.ray.Arrival;
import cz.paprsek.render.integrate.Paths;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;

/** The tracer of paths, of each of which a ledger is kept. */
final class PathTracker extends Paths {
    final Ledger ledger = new Ledger();

    PathTracker(World scene, int maxDepth, Passes sampling) {
        super(scene, maxDepth, sampling);
    }

    @Override
    public void following(boolean refracted, double red, double green, double blue) {
        ledger.following(red, green, blue);
    }

    @Override
    public void missed(Level level) {
        ledger.arrived(level, Ledger.SKY);
    }

    @Override
    public void met(Level level) {
        ledger.met(level);
    }

    @Override
    public void seen(Level level, int lamp) {
        ledger.arrived(level, lamp);
    }

    @Override
    public void sought(int lamp, Arrival arrival, double facing, double visibility) {
        ledger.sought(lamp);
    }

    @Override
    public void illuminated(double diffuse, double highlight, double red, double green, double blue) {
        ledger.illuminated(red, green, blue);
    }

    @Override
    public void averaged(int lamp, double red, double green, double blue) {
        ledger.averaged(lamp, red, green, blue);
    }

    @Override
    public void emitted(double red, double green, double blue) {
        ledger.emitted(red, green, blue);
    }

    @Override
    public void absorbed(int body, double length, double red, double green, double blue) {
        ledger.absorbed(red, green, blue);
    }

    @Override
    public void ended(Level level) {
        ledger.ended();
    }
}
