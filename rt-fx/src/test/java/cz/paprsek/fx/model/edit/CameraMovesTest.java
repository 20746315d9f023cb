package cz.paprsek.fx.model.edit;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Camera.Direction;
import cz.paprsek.scene.Camera.Target;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class CameraMovesTest {
    private static final Camera FRONT = Camera.lookingAt(new Vec3(0, 0, 8), Vec3.ZERO);
    private static final Camera FREE = Camera.looking(new Vec3(0, 0, 8), new Vec3(0, 0, -2));

    @Test
    void orbitingToTheRightStandsOnTheRight() {
        assertThat(CameraMoves.orbited(FRONT, Vec3.ZERO, 90, 0)).isEqualTo(FRONT.withPosition(new Vec3(8, 0, 0)));
    }

    @Test
    void aCameraWithADirectionKeepsLookingAtThePivot() {
        Camera moved = CameraMoves.orbited(FREE, Vec3.ZERO, 90, 0);
        assertThat(moved).isEqualTo(new Camera(new Vec3(8, 0, 0), new Direction(new Vec3(-1, 0, 0)), Vec3.Y, 45));
    }

    @Test
    void climbingStandsHigherAtTheSameDistance() {
        Camera moved = CameraMoves.orbited(FRONT, Vec3.ZERO, 0, 30);
        assertThat(moved.position().y()).isCloseTo(4, Offset.offset(1e-4));
        assertThat(moved.position().length()).isCloseTo(8, Offset.offset(1e-3));
        assertThat(moved.aim()).isEqualTo(FRONT.aim());
    }

    @Test
    void climbingStopsBeforeTheZenith() {
        Camera moved = CameraMoves.orbited(FRONT, Vec3.ZERO, 20, 500);
        assertThat(Math.toDegrees(Math.asin(moved.position().y() / 8))).isCloseTo(89, Offset.offset(1e-2));
        assertThat(CameraMoves.orbited(moved, Vec3.ZERO, 0, -500).position().y()).isCloseTo(-moved.position().y(), Offset.offset(1e-3));
    }

    @Test
    void panningMovesTheTargetToo() {
        Camera moved = CameraMoves.panned(FRONT, 2, 1);
        assertThat(moved.position()).isEqualTo(new Vec3(2, 1, 8));
        assertThat(moved.aim()).isEqualTo(new Target(new Vec3(2, 1, 0)));
        assertThat(CameraMoves.panned(FREE, 2, 1)).isEqualTo(FREE.withPosition(new Vec3(2, 1, 8)));
    }

    @Test
    void dollyingMultipliesTheDistance() {
        assertThat(CameraMoves.dollied(FRONT, Vec3.ZERO, 0.5).position()).isEqualTo(new Vec3(0, 0, 4));
    }

    @Test
    void positionsAreWrittenWithFewDigits() {
        Camera moved = CameraMoves.orbited(FRONT.withPosition(new Vec3(1.23, 4.56, 7.89)), Vec3.ZERO, 12.345, 6.789);
        for (double v : new double[] {moved.position().x(), moved.position().y(), moved.position().z()}) {
            assertThat(Double.toString(v).length()).as("%s", v).isLessThanOrEqualTo(8);
        }
    }

    @Test
    void theSizeOfTheSceneDoesNotMatter() {
        Camera tiny = Camera.lookingAt(new Vec3(0, 0, 8e-9), Vec3.ZERO);
        assertThat(CameraMoves.orbited(tiny, Vec3.ZERO, 90, 0).position().x()).isCloseTo(8e-9, Offset.offset(1e-13));
        Camera huge = Camera.lookingAt(new Vec3(0, 0, 8e12), Vec3.ZERO);
        assertThat(CameraMoves.orbited(huge, Vec3.ZERO, 90, 0).position()).isEqualTo(new Vec3(8e12, 0, 0));
    }
}
