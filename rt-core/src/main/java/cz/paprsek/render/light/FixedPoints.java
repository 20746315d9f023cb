package cz.paprsek.render.light;

import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.scene.Light;
import java.util.ArrayList;
import java.util.List;

/** Where lights are looked for by a sampler that has the same points for all pixels: so that others can be given them. */
public final class FixedPoints {
    private FixedPoints() {}

    /**
     * The points of a light: of a flat one in world space, of a sun's disc the directions towards them, of length 1.
     *
     * @param lamp its number in the scene
     * @return none for a light that is looked for at one point, and for a ball and those made in code, whose points depend on from where
     */
    public static List<Vec3> of(Light light, int lamp) {
        List<Vec3> points = new ArrayList<>();
        Lamp ready = Lamp.of(light);
        int count = ready.samples() > 1 && (ready instanceof AreaLamp || ready instanceof SunDiscLamp) ? ready.samples() : 0;
        Sampler sampler = Sampler.fixed(1);
        Arrival arrival = new Arrival();
        if (count > 0) {
            sampler.start(0, 0, 0);
            sampler.lights(Sampler.EYE, lamp, count);
        }
        for (int i = 0; i < count; i++) {
            sampler.next();
            points.add(ready instanceof AreaLamp area ? area.point(sampler.u, sampler.v, arrival) : ((SunDiscLamp) ready).direction(sampler.u, sampler.v, arrival));
        }
        return points;
    }
}
