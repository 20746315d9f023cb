package cz.paprsek.render.explain;

import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A ray that was followed, and the light it brought back.
 *
 * @param kind what made it
 * @param level 1 for a ray from the eye, 2 for those that it gives rise to, and so on
 * @param weight what its light is multiplied by where it is added to that of the ray before, channel by channel; 1 for a ray from the eye
 * @param origin world space
 * @param direction of length 1, world space
 * @param medium what it travels through
 * @param encounter what object it hits; empty if it sees a light or the background
 * @param seen what light it sees as it is, at which it ends
 * @param sight how the camera's lens made it; empty for rays that are not from the eye, and through pinholes
 * @param absorbed what the substance it comes through takes of the light it brings
 * @param light what it brings back, the exact sum of the encounter's {@linkplain Encounter#terms terms}, of which a share is left if there is an absorption
 */
public record TracedRay(
        Kind kind, int level, LinearRgb weight, Vec3 origin, Vec3 direction, Medium medium, Optional<Encounter> encounter,
        Optional<SeenLight> seen, Optional<Sight> sight, Optional<Absorption> absorbed, LinearRgb light) {
    public TracedRay {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(weight, "weight");
        Objects.requireNonNull(origin, "origin");
        Objects.requireNonNull(direction, "direction");
        Objects.requireNonNull(medium, "medium");
        Objects.requireNonNull(encounter, "encounter");
        Objects.requireNonNull(seen, "seen");
        Objects.requireNonNull(sight, "sight");
        Objects.requireNonNull(absorbed, "absorbed");
        Objects.requireNonNull(light, "light");
    }


    /** What makes a ray. */
    public enum Kind { PRIMARY, REFLECTED, REFRACTED }

    /** The rays it gives rise to: the mirrored one first. */
    public List<TracedRay> children() {
        return encounter.map(met -> Stream.concat(met.reflected().stream(), met.refracted().stream()).toList()).orElse(List.of());
    }

    /**
     * What a ray travels through.
     *
     * @param solid the object entered last; empty outside of all
     * @param refractiveIndex relative to the vacuum
     */
    public record Medium(Optional<InScene<BodyAt>> solid, double refractiveIndex) {
        public Medium {
            Objects.requireNonNull(solid, "solid");
        }

        /** Whether it is the inside of the object that a surface belongs to. */
        public boolean isInside(InScene<BodyAt> surface) {
            Objects.requireNonNull(surface, "surface");
            return solid.isPresent() && solid.get().part().equals(surface.part().object());
        }
    }

    /**
     * A light that a ray has met: its body, or the disc of a sun. The ray ends there, and brings the light's own radiance.
     *
     * @param light its number in the scene, from 0
     * @param name its name; empty for none
     * @param distance from the ray's origin; infinite for a sun
     * @param counted whether its light was counted where the ray starts, and is not again
     */
    public record SeenLight(int light, String name, double distance, boolean counted) {
        public SeenLight {
            Objects.requireNonNull(name, "name");
        }

        /** Its name in quotes; its number, from 1, if it has none. */
        public String label() {
            return name.isEmpty() ? "#" + (light + 1) : "\"" + name + "\"";
        }
    }

    /**
     * How a lens, other than a pinhole, makes a ray from the eye. What the two numbers are depends on it: of a thin lens and an orthographic camera
     * how far the ray starts from the camera's position, to the right and upwards, in scene units; of a spherical one longitude and latitude from
     * the view, in degrees; of a fisheye where on its circle of radius 1 the ray belongs.
     *
     * @param lens of the camera
     * @param across to the right
     * @param upwards towards the top of the picture
     * @param focus where all rays of this point of the picture meet, world space; of a thin lens only
     * @param isBlind whether the picture shows nothing there
     */
    public record Sight(Lens lens, double across, double upwards, Optional<Vec3> focus, boolean isBlind) {
        public Sight {
            Objects.requireNonNull(lens, "lens");
            Objects.requireNonNull(focus, "focus");
        }
    }

    /**
     * What a substance leaves of light on a stretch of its way: exp(−(1 − c)·d/D) of each channel.
     *
     * @param body whose inside it is
     * @param substance the material that says c and D
     * @param length d, scene units; infinite if the way has no end
     * @param left the share
     */
    public record Absorption(InScene<BodyAt> body, Material substance, double length, LinearRgb left) {
        public Absorption {
            Objects.requireNonNull(body, "body");
            Objects.requireNonNull(substance, "substance");
            Objects.requireNonNull(left, "left");
        }
    }
}
