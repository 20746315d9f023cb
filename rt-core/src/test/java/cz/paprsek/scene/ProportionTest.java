package cz.paprsek.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.util.stream.Stream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Numbers out of all proportion are refused where they are said, not found out in the middle of a picture. */
class ProportionTest {
    static Stream<Arguments> refused() {
        return Stream.of(
                row("sphere radius must be a number from 1.0E-45 to 1.0E45, but is 1.0E46", () -> new Sphere(1e46)),
                row("sphere radius must be a number from 1.0E-45 to 1.0E45, but is 1.0E-46", () -> new Sphere(1e-46)),
                row("rectangle width must be a number", () -> new Rectangle(0, 0, 1e-50, 1)),
                row("block min x must be a number", () -> new Block(new Vec3(-1e300, 0, 0), Vec3.ONE)),
                row("block depth must be a number", () -> new Block(Vec3.ZERO, new Vec3(1, 1, 1e-300))),
                row("position y must be a number", () -> Placement.at(0, 1e300, 0)),
                row("scale along z must be a number", () -> Placement.NONE.withScale(new Vec3(1, 1, 1e-300))),
                row("camera position x must be a number", () -> Camera.looking(new Vec3(1e300, 0, 0), Vec3.X)),
                row("target x must be a number", () -> Camera.lookingAt(Vec3.ZERO, new Vec3(1e300, 0, 0))),
                row("light position z must be a number", () -> Light.at(0, 0, 1e300)),
                row("light intensity must be a number from 0 to 1.0E12, but is 1.0E13", () -> Light.at(0, 0, 0).withIntensity(1e13)),
                row("larger than 1.0E45 times its size", () -> nested(1e30, 1e30)),
                row("must not make it flat", ProportionTest::turnedInAFlatSpace));
    }

    @ParameterizedTest
    @MethodSource("refused")
    void numberOutOfProportionIsRefused(String sentence, ThrowingCallable made) {
        assertThatThrownBy(made).isInstanceOf(IllegalArgumentException.class).hasMessageContaining(sentence);
    }

    @Test
    void aShapeDrawnOutAndTurnedFindsTheWayBack() {
        for (double length : new double[] {1e-45, 1e-9, 1, 1e9, 1e45}) {
            Affine map = new Placement(Vec3.ZERO, new Vec3(20, 50, 70), new Vec3(length, 1, 2)).toParent();
            Vec3 back = map.inverse().point(map.point(new Vec3(0, 1, 1)));
            assertThat(back.minus(new Vec3(0, 1, 1)).y()).isLessThan(1e-14);
            assertThat(back.minus(new Vec3(0, 1, 1)).z()).isLessThan(1e-14);
            assertThat(back.x() * length).isLessThan(1e-14);
        }
    }

    private static Scene nested(double outer, double inner) {
        Csg ball = Csg.union(Operand.of(new Sphere(1)).placed(Placement.NONE.withScale(new Vec3(inner, inner, inner))));
        return Scene.EMPTY.plus(SceneObject.of(ball).scaled(outer, 1, outer));
    }

    private static Scene turnedInAFlatSpace() {
        Csg ball = Csg.union(Operand.of(new Sphere(1)).rotated(30, 40, 50));
        return Scene.EMPTY.plus(SceneObject.of(ball).scaled(1e20, 1, 1));
    }

    private static Arguments row(String sentence, ThrowingCallable made) {
        return Arguments.of(sentence, made);
    }
}
