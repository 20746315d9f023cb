package cz.paprsek.render.integrate;

import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;

/**
 * By which of its lobes a surface sends a path on: as often as they send light, about. Scratch of one worker. What is mirrored and what shines
 * through, rough or smooth, count as one.
 */
final class Choice {
    private final Lobe lobe;
    /** How often the path goes on by what is diffuse, by the highlight, and by the rest: together 1, or 0 if it ends. */
    double diffuse;
    double highlight;
    double rest;

    Choice(Lobe lobe) {
        this.lobe = lobe;
    }

    /** Makes ready for a hit; false if the path ends there. */
    boolean at(Level level, Finish finish) {
        highlight = finish.highlights;
        rest = finish.reflection + finish.transparency;
        if (!(highlight + rest > 0)) {
            // Most surfaces: without three divisions.
            boolean scatters = finish.diffusion > 0 && (level.colorRed > 0 || level.colorGreen > 0 || level.colorBlue > 0);
            diffuse = scatters ? 1 : 0;
            return scatters;
        }
        diffuse = finish.diffusion * Math.max(level.colorRed, Math.max(level.colorGreen, level.colorBlue));
        double all = diffuse + highlight + rest;
        if (!(all > 0)) {
            return false;
        }
        diffuse /= all;
        highlight /= all;
        rest /= all;
        return true;
    }

    /**
     * How probable it is that the path goes on in a direction, per solid angle; where nothing but a direction that is sure leads there, 0, and where the surface
     * itself, which may be turned otherwise than its normal says, is in the way. Of a rough surface the {@link Lobe} must have looked there.
     */
    double density(Level level, Finish finish, Arrival to) {
        Hit hit = level.hit;
        double facing = hit.sx * to.x + hit.sy * to.y + hit.sz * to.z;
        double side = hit.nx * to.x + hit.ny * to.y + hit.nz * to.z;
        if (facing > 0 != side > 0) {
            return 0;
        }
        double density = finish.alpha > 0 ? rest * lobe.density : 0;
        if (facing > 0) {
            density += diffuse * facing / Math.PI;
            if (highlight > 0) {
                density += highlight * finish.highlight(level.mirrorX * to.x + level.mirrorY * to.y + level.mirrorZ * to.z) / (Math.PI * finish.highlights);
            }
        }
        return density;
    }
}
