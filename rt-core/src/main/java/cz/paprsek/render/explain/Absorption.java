package cz.paprsek.render.explain;

import cz.paprsek.material.Material;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.Objects;

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
