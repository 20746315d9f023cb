import cz.paprsek.image.ImageFiles;
import cz.paprsek.material.Material;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.CustomSolid;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.check.ShapeCheck;
import java.io.IOException;
import java.nio.file.Path;

/** A bowl of revolution, y from x² + z² up to 1, as a shape of one's own: of bronze, with a hole in it, and a picture of it. */
public final class Bowl {
    private Bowl() {}

    /** x² + z² ≤ y ≤ 1. */
    record Paraboloid() implements CustomSolid {
        private static final int LID = 0;
        private static final int BOWL = 1;

        @Override
        public Bounds bounds() {
            return Bounds.of(new Vec3(-1, 0, -1), new Vec3(1, 1, 1));
        }

        /** Where x² + z² − y = 0 along the line, and where y = 1: inside is what is within both. */
        @Override
        public void cross(Line line) {
            double a = line.dx * line.dx + line.dz * line.dz;
            double b = line.ox * line.dx + line.oz * line.dz - line.dy / 2;
            double c = line.ox * line.ox + line.oz * line.oz - line.oy;
            double enter;
            double leave;
            if (a > 0) {
                double under = b * b - a * c;
                if (!(under > 0)) {
                    return;
                }
                // Of the two roots one is found without a difference of like numbers, and the other from it.
                double q = -(b + Math.copySign(Math.sqrt(under), b));
                enter = Math.min(q / a, c / q);
                leave = Math.max(q / a, c / q);
            } else {
                // Along the axis there is one.
                double only = c / line.dy;
                enter = line.dy > 0 ? only : Double.NEGATIVE_INFINITY;
                leave = line.dy > 0 ? Double.POSITIVE_INFINITY : only;
            }
            double lid = (1 - line.oy) / line.dy;
            int enterFace = BOWL;
            int leaveFace = BOWL;
            if (line.dy > 0 && lid < leave) {
                leave = lid;
                leaveFace = LID;
            } else if (line.dy < 0 && lid > enter) {
                enter = lid;
                enterFace = LID;
            } else if (line.dy == 0 && line.oy > 1) {
                return;
            }
            if (enter < leave) {
                line.cross(enter, enterFace);
                line.cross(leave, leaveFace);
            }
        }

        /** Outwards: the gradient of x² + z² − y. */
        @Override
        public void normal(int face, Hit hit) {
            if (face == LID) {
                hit.normal(0, 1, 0);
            } else {
                double length = Math.sqrt(4 * (hit.px * hit.px + hit.pz * hit.pz) + 1);
                hit.normal(2 * hit.px / length, -1 / length, 2 * hit.pz / length);
            }
        }
    }

    public static void main(String[] args) throws IOException {
        ShapeCheck.problems(new Paraboloid()).forEach(System.err::println);
        Scene scene = Scene.EMPTY
                .withCamera(Camera.lookingAt(new Vec3(1, 2.5, 3.5), new Vec3(0, 0.5, 0)))
                .plus(Light.at(4, 6, 5))
                .plus(SceneObject.of(Csg.difference(new Paraboloid(), new Cylinder(0.6, 2))).madeOf(Material.color(205, 127, 50).withHighlight(0.6, 40)));
        ImageFiles.write(Renderer.render(scene), Path.of("paraboloid.png"));
    }
}
