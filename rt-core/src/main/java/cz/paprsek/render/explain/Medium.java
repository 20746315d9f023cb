package cz.paprsek.render.explain;

import cz.paprsek.scene.InScene;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.Objects;
import java.util.Optional;

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
