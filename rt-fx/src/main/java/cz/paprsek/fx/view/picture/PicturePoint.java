package cz.paprsek.fx.view.picture;

import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.RenderScene.Pick;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.ScenePath;
import java.util.Optional;

/**
 * A point of a rendered picture that the user points at.
 *
 * @param scene what was rendered
 * @param settings how: the size of the picture, its depth and samples
 * @param x columns from the left edge, in pixels and parts of one; the centre of the first pixel is 0.5
 * @param y rows from the top edge
 */
public record PicturePoint(RenderScene scene, RenderSettings settings, double x, double y) {

    /** The pixel's column, counted from 0. */
    public int column() {
        return Math.min((int) x, settings.width() - 1);
    }

    /** The pixel's row, counted from 0. */
    public int row() {
        return Math.min((int) y, settings.height() - 1);
    }

    /** The same place in a picture with other settings, such as one of another size. */
    public PicturePoint in(RenderSettings other) {
        return new PicturePoint(scene, other, x / settings.width() * other.width(), y / settings.height() * other.height());
    }

    /** What is seen there; empty for the background. */
    public Optional<Pick> pick() {
        return Pick.at(scene, settings, x, y);
    }

    /** The normal of the surface that is seen there, of length 1, on the side that is seen; towards the eye where a light is seen, and upwards where nothing is. */
    public Vec3 side() {
        TracedRay ray = scene.explainPoint(settings.withMaxDepth(1), x, y);
        return ray.encounter().map(met -> met.place().towardsViewer()).or(() -> ray.seen().map(light -> ray.direction().negated())).orElse(Vec3.Y);
    }

    /** Where in the scene stands what is seen there: the object, or the operand that the surface belongs to, or the light. */
    public Optional<ScenePath> place() {
        return pick().map(Pick::place);
    }
}
