package cz.paprsek.render.explain;

import cz.paprsek.math.Vec3;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.List;
import java.util.Objects;

/**
 * What one light adds at one point, and the shadow ray that went to look for it: V·I·(kD·C·max(0, N·L) + kS·max(0, R·L)ⁿ).
 *
 * @param light its number in the scene, from 0
 * @param name its name; empty for none
 * @param position of the light, world space
 * @param intensity I, its colour times its intensity
 * @param direction L, from the point to the light, of length 1
 * @param distance to the light
 * @param facing N·L
 * @param alignment R·L
 * @param visibility V, the share of the light that arrives; 0 also if the surface is turned away
 * @param obstacles what stands between, the nearest to the point first, up to the first opaque one
 * @param diffuse kD·max(0, N·L); 0 in shadow
 * @param highlight kS·max(0, R·L)ⁿ; 0 in shadow
 * @param added the whole term
 */
public record LightTerm(
        int light,
        String name,
        Vec3 position,
        LinearRgb intensity,
        Vec3 direction,
        double distance,
        double facing,
        double alignment,
        double visibility,
        List<Obstacle> obstacles,
        double diffuse,
        double highlight,
        LinearRgb added) {

    public LightTerm {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(position, "position");
        Objects.requireNonNull(intensity, "intensity");
        Objects.requireNonNull(direction, "direction");
        Objects.requireNonNull(added, "added");
        obstacles = List.copyOf(obstacles);
    }

    /** The same with what the light adds. */
    public LightTerm lit(double diffuseShare, double highlightShare, LinearRgb term) {
        return new LightTerm(light, name, position, intensity, direction, distance, facing, alignment, visibility, obstacles,
                diffuseShare, highlightShare, term);
    }

    /** Its name in quotes; its number, from 1, if it has none. */
    public String label() {
        return name.isEmpty() ? "#" + (light + 1) : "\"" + name + "\"";
    }

    /** Whether the surface faces the light; if not, nobody looks what stands between. */
    public boolean isFacing() {
        return facing > 0;
    }

    /**
     * A surface between a point and a light.
     *
     * @param distance from the point
     * @param transparency kT, the share of the light it lets through
     */
    public record Obstacle(InScene<BodyAt> surface, double distance, double transparency) {
        public Obstacle {
            Objects.requireNonNull(surface, "surface");
        }
    }
}
