package cz.paprsek.render.light;

import cz.paprsek.material.Rgb;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;

/** Bodies that shine, so many that one of them is looked for at a time, and counts for those that are not. Scratch of one worker. */
public final class ManyLamps extends Lamp {
    private final Emitters emitters;
    private final LampTree tree;
    private final LampTree.Choice choice = new LampTree.Choice();

    ManyLamps(Emitters emitters, LampTree tree) {
        super(Rgb.WHITE, 1);
        this.emitters = emitters;
        this.tree = tree;
    }

    /** Which of the bodies was chosen last. */
    public int chosen() {
        return choice.lamp;
    }

    @Override
    public int samples() {
        return BODY_SAMPLES;
    }

    @Override
    public boolean sample(Hit from, double u, double v, Arrival out) {
        tree.choose(from.px, from.py, from.pz, u, choice);
        boolean shines = emitters.lamp(choice.lamp).sample(from, choice.left, v, out);
        double k = Math.min(MOST, 1 / choice.chance);
        out.light(k * out.red, k * out.green, k * out.blue);
        return shines;
    }

    /** Of the body that was chosen last. */
    @Override
    public double density(double x, double y, double z, double dx, double dy, double dz, double distance) {
        return density(choice.lamp, x, y, z, dx, dy, dz, distance);
    }

    /** How probable it is that a body is chosen, and of it a direction, per solid angle. */
    public double density(int body, double x, double y, double z, double dx, double dy, double dz, double distance) {
        return tree.chance(body, x, y, z) * emitters.lamp(body).density(x, y, z, dx, dy, dz, distance);
    }
}
