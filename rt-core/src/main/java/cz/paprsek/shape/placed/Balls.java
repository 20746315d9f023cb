package cz.paprsek.shape.placed;

/**
 * Balls side by side, to find out which of a row of surfaces a ray passes by: asking those by themselves takes a call and a walk through
 * memory each. What is no ball may always be met.
 */
public final class Balls {
    /** For each surface x, y, z and the square of the radius, which is infinite if it is no ball; empty if none is. */
    private final double[] values;

    /** Looks through surfaces, which keep their numbers. */
    public Balls(Surface[] surfaces) {
        double[] found = new double[4 * surfaces.length];
        boolean any = false;
        for (int i = 0; i < surfaces.length; i++) {
            if (surfaces[i] instanceof Ball ball) {
                ball.put(found, 4 * i);
                any = true;
            } else {
                found[4 * i + 3] = Double.POSITIVE_INFINITY;
            }
        }
        values = any ? found : new double[0];
    }

    /** Whether the line of the ray may meet a surface; for a ball by the very arithmetic by which it is met. */
    public boolean mayBeMet(int surface, Ray ray) {
        return values.length == 0
                || Ball.half(ray, values[4 * surface], values[4 * surface + 1], values[4 * surface + 2], values[4 * surface + 3]) > 0;
    }
}
