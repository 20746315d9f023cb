package cz.paprsek.render.mode;

import cz.paprsek.material.Rgb;
import java.util.List;

/**
 * A logarithmic scale of colours for counts, from dark for 1 to bright for the largest: the same in every picture, so that pictures can be
 * compared.
 *
 * @param largest what is as bright as can be; anything above is, too
 */
public record HeatScale(int largest) {
    public static final HeatScale RAYS = new HeatScale(1024);
    public static final HeatScale SAMPLES = new HeatScale(256);
    public static final HeatScale NODES = new HeatScale(16_384);

    private static final List<Rgb> COLORS = List.of(new Rgb(8, 8, 40), new Rgb(58, 20, 130), new Rgb(165, 35, 125), new Rgb(235, 85, 60),
            new Rgb(250, 175, 50), new Rgb(255, 250, 200));

    /** The colour of a count: black for 0. */
    public Rgb color(long count) {
        return count <= 0 ? Rgb.BLACK : at(StrictMath.log((double) count) / StrictMath.log(largest));
    }

    /** The colour at a place of the scale, from 0 to 1. */
    public Rgb at(double place) {
        double x = Math.min(1, Math.max(0, place)) * (COLORS.size() - 1);
        int below = Math.min((int) x, COLORS.size() - 2);
        return mixed(COLORS.get(below), COLORS.get(below + 1), x - below);
    }

    private static Rgb mixed(Rgb a, Rgb b, double share) {
        return new Rgb(a.red() + share * (b.red() - a.red()), a.green() + share * (b.green() - a.green()), a.blue() + share * (b.blue() - a.blue()));
    }
}
