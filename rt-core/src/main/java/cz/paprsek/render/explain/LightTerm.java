package cz.paprsek.render.explain;

import java.util.List;
import java.util.Objects;

/**
 * What one light adds at one point, and the shadow rays that went to look for it: of several, the mean of what they bring.
 *
 * @param light its number in the scene, from 0
 * @param name its name; empty for none
 * @param rays at least one; several for a light with a size
 * @param added the whole term
 */
public record LightTerm(int light, String name, List<ShadowRay> rays, LinearRgb added) {

    public LightTerm {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(added, "added");
        rays = List.copyOf(rays);
    }

    /** The first of its rays, and of a light without a size the only one. */
    public ShadowRay ray() {
        return rays.get(0);
    }

    /** The mean share of the light that arrives. */
    public double visibility() {
        return rays.stream().mapToDouble(ShadowRay::visibility).sum() / rays.size();
    }

    /** Its name in quotes; its number, from 1, if it has none. */
    public String label() {
        return name.isEmpty() ? "#" + (light + 1) : "\"" + name + "\"";
    }
}
