package cz.paprsek.shape.check;

import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Shape;
import java.util.List;

/**
 * Tries a shape with thousands of lines, as it stands and turned, stretched, mirrored, tiny and huge, and says in what it breaks its word. To be
 * called in the tests of whoever makes a shape in code.
 */
public final class ShapeCheck {
    private static final List<Placement> PLACEMENTS = List.of(
            Placement.NONE,
            Placement.at(3, -2, 1).withRotation(new Vec3(20, 50, -70)),
            Placement.at(-1, 0.5, 2).withRotation(new Vec3(-30, 10, 45)).withScale(new Vec3(0.4, 1.7, 1.1)),
            Placement.at(0.2, 1, -3).withRotation(new Vec3(90, 0, 180)).withScale(new Vec3(-1.5, 0.8, 1.5)),
            Placement.at(1e-6, 0, 0).withRotation(new Vec3(5, 6, 7)).withScale(new Vec3(1e-6, 1e-6, 1e-6)),
            Placement.at(0, -1e6, 0).withRotation(new Vec3(8, 9, 10)).withScale(new Vec3(1e6, 1e6, 1e6)));

    private ShapeCheck() {}

    /**
     * What is wrong with a shape: a sentence for each kind of fault, with the first place where it was found, in the shape's own space. Empty if
     * nothing was found. The lines are the same at every call.
     */
    public static List<String> problems(Shape shape) {
        Problems problems = new Problems();
        for (Placement placement : PLACEMENTS) {
            if (problems.isFatal()) {
                break;
            }
            new Trial(shape, placement.toParent(), problems).run();
        }
        return problems.sentences();
    }
}
