package cz.paprsek.render.explain;

import cz.paprsek.math.Vec3;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.ScenePath;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

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

    /**
     * What a rough surface strews of light from one direction towards the viewer.
     *
     * @param spread D, how many of its facets are turned so that they send it there
     * @param seen G₁, the share of them that the viewer sees
     * @param lit G₁, the share of them that the light reaches
     * @param value M = π·f·cos θ: of what is mirrored π·kR·F·D·G₁·G₁/(4·N·v)
     */
    public record Strewn(double spread, double seen, double lit, LinearRgb value) {
        public Strewn {
            Objects.requireNonNull(value, "value");
        }
    }

    /**
     * A ray that went to look for a light, and what the light brings along it: V·τ·I·(kD·C·max(0, N·L) + kS·max(0, R·L)ⁿ).
     *
     * @param target the point of the light, world space; empty for a sun
     * @param intensity I, what arrives from there if nothing is in the way; black if the light does not shine this way, or a rough surface
     *        strews nothing of it the way that is looked
     * @param direction L, from the point to the light, of length 1
     * @param distance to the light; infinite for a sun
     * @param facing N·L
     * @param alignment R·L
     * @param visibility V, the share of the light that arrives; 0 also if the surface is turned away
     * @param obstacles what stands between, the nearest to the point first, up to the first opaque one
     * @param absorptions what substances on the way take, the nearest to the point first
     * @param left τ, the share that they leave; white also in shadow
     * @param strewn what a rough surface strews of it
     * @param diffuse kD·max(0, N·L); 0 in shadow
     * @param highlight kS·max(0, R·L)ⁿ; 0 in shadow
     * @param added what it brings
     */
    public record ShadowRay(
            Optional<Vec3> target,
            LinearRgb intensity,
            Vec3 direction,
            double distance,
            double facing,
            double alignment,
            double visibility,
            List<Obstacle> obstacles,
            List<TracedRay.Absorption> absorptions,
            LinearRgb left,
            Optional<Strewn> strewn,
            double diffuse,
            double highlight,
            LinearRgb added) {

        public ShadowRay {
            Objects.requireNonNull(target, "target");
            Objects.requireNonNull(intensity, "intensity");
            Objects.requireNonNull(direction, "direction");
            Objects.requireNonNull(added, "added");
            Objects.requireNonNull(left, "left");
            Objects.requireNonNull(strewn, "strewn");
            obstacles = List.copyOf(obstacles);
            absorptions = List.copyOf(absorptions);
        }

        /** The same with what the light brings. */
        public ShadowRay lit(Optional<Strewn> by, double diffuseShare, double highlightShare, LinearRgb term) {
            return new ShadowRay(target, intensity, direction, distance, facing, alignment, visibility, obstacles, absorptions, left, by, diffuseShare, highlightShare, term);
        }

        /** Whether the surface faces the light, and that shines this way; if not, nobody looked what stands between. */
        public boolean isSent() {
            return (facing > 0 || visibility > 0) && !intensity.equals(LinearRgb.BLACK);
        }

        /**
         * A surface between a point and a light.
         *
         * @param surface that of an object or operand, or of another light
         * @param distance from the point
         * @param transparency kT, the share of the light it lets through
         */
        public record Obstacle(InScene<? extends ScenePath> surface, double distance, double transparency) {
            public Obstacle {
                Objects.requireNonNull(surface, "surface");
            }
        }
    }
}
