package cz.paprsek.scene;

import java.util.Objects;

/** A part of a scene together with the scene: a camera, a light, a named material, the place of an object or operand. */
public record InScene<T>(Scene scene, T part) {
    public InScene {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(part, "part");
    }

    /** The part alone, of which the scene is not: {@code ball}, or {@code bowl/block#2} for an operand. */
    @Override
    public String toString() {
        return part instanceof ScenePath path && path.isIn(scene) ? path.text(scene) : part.toString();
    }
}
