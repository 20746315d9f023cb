package cz.paprsek.render.explain;

import cz.paprsek.math.Vec3;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A ray that was followed, and the light it brought back.
 *
 * @param kind what made it
 * @param level 1 for a ray from the eye, 2 for those that it gives rise to, and so on
 * @param weight what its light is multiplied by where it is added to that of the ray before; 1 for a ray from the eye
 * @param origin world space
 * @param direction of length 1, world space
 * @param medium what it travels through
 * @param encounter what object it hits; empty if it sees a light or the background
 * @param seen what light it sees as it is, at which it ends
 * @param light what it brings back, the exact sum of the encounter's {@linkplain Encounter#terms terms}
 */
public record TracedRay(
        Kind kind, int level, double weight, Vec3 origin, Vec3 direction, Medium medium, Optional<Encounter> encounter,
        Optional<SeenLight> seen, LinearRgb light) {
    public TracedRay {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(origin, "origin");
        Objects.requireNonNull(direction, "direction");
        Objects.requireNonNull(medium, "medium");
        Objects.requireNonNull(encounter, "encounter");
        Objects.requireNonNull(seen, "seen");
        Objects.requireNonNull(light, "light");
    }


    /** What makes a ray. */
    public enum Kind { PRIMARY, REFLECTED, REFRACTED }

    /** The rays it gives rise to: the mirrored one first. */
    public List<TracedRay> children() {
        return encounter.map(met -> Stream.concat(met.reflected().stream(), met.refracted().stream()).toList()).orElse(List.of());
    }
}
