package cz.paprsek.fx.model.section;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Sections of solids whose areas are known. */
class CutFaceTest {
    private static CutFace face(SceneObject object, Axis axis, double place) {
        return CutFace.of(ScenePath.body(0).placed(Scene.EMPTY.plus(object)), axis, place, 40);
    }

    /** Holes run the other way around, and so count less than nothing. */
    private static double area(CutFace face, Axis axis) {
        double sum = 0;
        for (List<Vec3> outline : face.outlines()) {
            for (int i = 0; i < outline.size(); i++) {
                Vec3 cross = outline.get(i).cross(outline.get((i + 1) % outline.size()));
                sum += axis.of(cross) / 2;
            }
        }
        return Math.abs(sum);
    }

    @Test
    void aBallHasACircle() {
        CutFace face = face(SceneObject.of(new Sphere(1)).at(5, 0, 2), Axis.Z, 2.5);
        assertThat(face.outlines()).hasSize(1);
        assertThat(face.outlines().get(0)).allSatisfy(point -> assertThat(point.minus(new Vec3(5, 0, 2)).length()).isCloseTo(1, within(2e-4)));
        assertThat(area(face, Axis.Z)).isCloseTo(0.75 * Math.PI, within(0.01));
    }

    @Test
    void aHollowBallHasARingAndATorusTwoCircles() {
        CutFace ring = face(SceneObject.of(Csg.difference(Operand.of(new Sphere(1)), Operand.of(new Sphere(0.6)))), Axis.X, 0);
        assertThat(ring.outlines()).hasSize(2);
        assertThat(area(ring, Axis.X)).isCloseTo(0.64 * Math.PI, within(0.01));
        CutFace torus = face(SceneObject.of(new Torus(1, 0.25)), Axis.X, 0);
        assertThat(torus.outlines()).hasSize(2);
        assertThat(area(torus, Axis.X)).isCloseTo(2 * Math.PI / 16, within(0.01));
    }

    @Test
    void cornersAreNotCutOffAndBesideThereIsNothing() {
        SceneObject block = SceneObject.of(new Block(new Vec3(-1, -2, -3), new Vec3(1, 2, 3)));
        assertThat(area(face(block, Axis.Y, 0.5), Axis.Y)).isCloseTo(12, within(0.01));
        assertThat(face(block, Axis.Y, 2.5).outlines()).isEmpty();
    }
}
