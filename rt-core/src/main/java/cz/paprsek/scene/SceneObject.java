package cz.paprsek.scene;

import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Placement.Pivot;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import java.util.Objects;

/**
 * A shape placed in the world and made of something.
 *
 * @param name free text for people; empty for none, unique among the scene's objects otherwise
 * @param pivot what hands turn and scale it about; pictures do not depend on it
 * @param hidden whether it is left out of pictures, as if it were not there
 */
public record SceneObject(String name, Shape shape, Placement placement, Pivot pivot, boolean hidden, MaterialSource material) {
    private static final int MOST_TRIANGLES = 100_000;

    public SceneObject {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(shape, "shape");
        Objects.requireNonNull(placement, "placement");
        Objects.requireNonNull(pivot, "pivot");
        Objects.requireNonNull(material, "material");
    }

    /** One that is seen, and turned about its middle. */
    public SceneObject(String name, Shape shape, Placement placement, MaterialSource material) {
        this(name, shape, placement, Placement.MIDDLE, false, material);
    }

    public static SceneObject of(Shape shape) {
        return new SceneObject("", shape, Placement.NONE, Inherited.INHERITED);
    }

    public SceneObject named(String value) {
        return new SceneObject(value, shape, placement, pivot, hidden, material);
    }

    public SceneObject at(double x, double y, double z) {
        return placed(placement.withPosition(new Vec3(x, y, z)));
    }

    /** With a rotation in degrees about x, then y, then z. */
    public SceneObject rotated(double x, double y, double z) {
        return placed(placement.withRotation(new Vec3(x, y, z)));
    }

    public SceneObject scaled(double x, double y, double z) {
        return placed(placement.withScale(new Vec3(x, y, z)));
    }

    public SceneObject placed(Placement value) {
        return new SceneObject(name, shape, value, pivot, hidden, material);
    }

    public SceneObject withShape(Shape value) {
        return new SceneObject(name, value, placement, pivot, hidden, material);
    }

    /**
     * Whether paths, if it shines, look for it as they do for lights: a ball that is not stretched, a rectangle, a disc, and a block with sharp edges. Other shapes that
     * shine they only find by chance.
     */
    public boolean isSoughtIfItShines() {
        return shape instanceof Rectangle || shape instanceof Disc || (shape instanceof Block block && block.rounding() == 0)
                || (shape instanceof Sphere && placement.toParent().uniformScale() > 0)
                || (shape instanceof Mesh mesh && !(material instanceof Inherited) && (!mesh.isRead() || mesh.triangles().count() <= MOST_TRIANGLES));
    }

    /** Left out of pictures, or not. */
    public SceneObject hidden(boolean value) {
        return new SceneObject(name, shape, placement, pivot, value, material);
    }

    /** Made of the given material. */
    public SceneObject madeOf(MaterialSource value) {
        return new SceneObject(name, shape, placement, pivot, hidden, value);
    }

    /** Made of the scene's material of that name. */
    public SceneObject madeOf(String materialName) {
        return madeOf(new MaterialName(materialName));
    }
}
