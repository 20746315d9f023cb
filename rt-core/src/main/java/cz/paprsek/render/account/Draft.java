package cz.paprsek.render.account;

import cz.paprsek.material.Material;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.Encounter.Facet;
import cz.paprsek.render.explain.Encounter.Reading;
import cz.paprsek.render.explain.Encounter.Refraction;
import cz.paprsek.render.explain.Encounter.Split;
import cz.paprsek.render.explain.LightTerm;
import cz.paprsek.render.explain.LightTerm.ShadowRay;
import cz.paprsek.render.explain.LightTerm.Strewn;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.TracedRay.Absorption;
import cz.paprsek.render.integrate.ShadowWalk;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The account of a ray under way: what is known of it once it has hit something, and the terms so far. */
final class Draft {
    private final TracedRay ray;
    public final Encounter.Place place;
    private final Material material;
    private final List<Reading> readings;
    private final LinearRgb color;
    private final LinearRgb ambientLight;
    public final ShadowWalk.Start start;
    /** For light that comes through a rough surface from beyond it. */
    public ShadowWalk.Start startBeyond;
    private final List<LightTerm> lights = new ArrayList<>();
    public LinearRgb emitted = LinearRgb.BLACK;
    public Optional<Refraction> refraction = Optional.empty();
    public Optional<Split> split = Optional.empty();
    public Optional<Facet> facet = Optional.empty();
    private Optional<TracedRay> reflected = Optional.empty();
    private Optional<TracedRay> refracted = Optional.empty();

    /** @param ray the ray so far, without an encounter; its light is the ambient term */
    public Draft(TracedRay ray, Encounter.Place place, Material material, List<Reading> readings, LinearRgb color, LinearRgb ambientLight, ShadowWalk.Start start) {
        this.ray = ray;
        this.place = place;
        this.material = material;
        this.readings = List.copyOf(readings);
        this.color = color;
        this.ambientLight = ambientLight;
        this.start = start;
        this.startBeyond = start;
    }

    /** Adds a shadow ray to a light; several in a row to one are one term. */
    void sought(int lamp, String name, ShadowRay ray) {
        LightTerm last = lights.isEmpty() ? null : lights.get(lights.size() - 1);
        if (last != null && last.light() == lamp) {
            List<ShadowRay> rays = new ArrayList<>(last.rays());
            rays.add(ray);
            lights.set(lights.size() - 1, new LightTerm(lamp, name, rays, LinearRgb.BLACK));
        } else {
            lights.add(new LightTerm(lamp, name, List.of(ray), LinearRgb.BLACK));
        }
    }

    /** Says what the last shadow ray brings: all of its light's term, unless that turns out to be a mean. */
    void lit(Optional<Strewn> strewn, double diffuse, double highlight, LinearRgb light) {
        LightTerm last = lights.get(lights.size() - 1);
        List<ShadowRay> rays = new ArrayList<>(last.rays());
        rays.set(rays.size() - 1, rays.get(rays.size() - 1).lit(strewn, diffuse, highlight, light));
        lights.set(lights.size() - 1, new LightTerm(last.light(), last.name(), rays, light));
    }

    /** Says what the shadow rays of the last light bring together. */
    void averaged(LinearRgb light) {
        LightTerm last = lights.get(lights.size() - 1);
        lights.set(lights.size() - 1, new LightTerm(last.light(), last.name(), last.rays(), light));
    }

    public void add(TracedRay child) {
        if (child.kind() == TracedRay.Kind.REFLECTED) {
            reflected = Optional.of(child);
        } else {
            refracted = Optional.of(child);
        }
    }

    public TracedRay finished(Optional<Absorption> absorbed, LinearRgb light, int maxDepth) {
        boolean cutOff = ray.level() == maxDepth && (material.reflection() > 0 || material.transparency() > 0);
        Encounter encounter = new Encounter(place, material, readings, color, ambientLight, ray.light(), emitted, lights, refraction, split, facet, reflected, refracted, cutOff);
        return new TracedRay(ray.kind(), ray.level(), ray.weight(), ray.origin(), ray.direction(), ray.medium(), Optional.of(encounter), Optional.empty(), ray.sight(), absorbed, light);
    }
}
