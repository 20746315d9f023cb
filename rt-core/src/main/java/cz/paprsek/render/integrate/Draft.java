package cz.paprsek.render.integrate;

import cz.paprsek.material.Material;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.LightTerm;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.Refraction;
import cz.paprsek.render.explain.TracedRay;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The account of a ray under way: what is known of it once it has hit something, and the terms so far. */
public final class Draft {
    private final TracedRay ray;
    public final Encounter.Place place;
    private final Material material;
    private final LinearRgb color;
    private final LinearRgb ambientLight;
    public final ShadowWalk.Start start;
    public final List<LightTerm> lights = new ArrayList<>();
    public Optional<Refraction> refraction = Optional.empty();
    private Optional<TracedRay> reflected = Optional.empty();
    private Optional<TracedRay> refracted = Optional.empty();

    /** @param ray the ray so far, without an encounter; its light is the ambient term */
    public Draft(TracedRay ray, Encounter.Place place, Material material, LinearRgb color, LinearRgb ambientLight, ShadowWalk.Start start) {
        this.ray = ray;
        this.place = place;
        this.material = material;
        this.color = color;
        this.ambientLight = ambientLight;
        this.start = start;
    }

    public void add(TracedRay child) {
        if (child.kind() == TracedRay.Kind.REFLECTED) {
            reflected = Optional.of(child);
        } else {
            refracted = Optional.of(child);
        }
    }

    public TracedRay finished(LinearRgb light, int maxDepth) {
        boolean cutOff = ray.level() == maxDepth && (material.reflection() > 0 || material.transparency() > 0);
        Encounter encounter = new Encounter(place, material, color, ambientLight, ray.light(), lights, refraction, reflected, refracted, cutOff);
        return new TracedRay(ray.kind(), ray.level(), ray.weight(), ray.origin(), ray.direction(), ray.medium(), Optional.of(encounter), light);
    }
}
