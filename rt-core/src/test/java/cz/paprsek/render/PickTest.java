package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderScene.Pick;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class PickTest {
    private static final Csg BITTEN = Csg.difference(new Sphere(1), new Block(new Vec3(-0.1, -0.1, 0), new Vec3(0.1, 0.1, 2)));
    /** The camera stands at z = 5 and looks along −z; the picture is 33 × 25. */
    private static final Scene SCENE = Scenes.empty().plus(
            SceneObject.of(new Sphere(1)).at(-2, 0, 0),
            SceneObject.of(Csg.union(Operand.of(new Sphere(0.1)).at(0, 9, 0), Operand.of(BITTEN))));

    private static Pick at(double x, double y) {
        return Pick.at(RenderScene.of(SCENE), SCENE.settings(), x, y).orElseThrow();
    }

    @Test
    void thePrimitiveThatIsSeenIsFoundInNestedOperations() {
        Pick bottomOfTheHole = at(16.5, 12.5);
        assertThat(bottomOfTheHole.place()).isEqualTo(ScenePath.body(1, 1, 1));
        assertThat(bottomOfTheHole.distance()).isCloseTo(5, Offset.offset(1e-12));
        Pick besideTheHole = at(18.5, 12.5);
        assertThat(besideTheHole.place()).isEqualTo(ScenePath.body(1, 1, 0));
    }

    @Test
    void aPlainObjectHasNoOperands() {
        double column = 16.5 - 2 / (5 * 2 * Math.tan(Math.PI / 8)) * 25;
        Pick pick = at(column, 12.5);
        assertThat(pick.place()).isEqualTo(ScenePath.body(0));
        assertThat(pick.point().minus(new Vec3(-2, 0, 0)).length()).isCloseTo(1, Offset.offset(1e-12));
    }

    @Test
    void aLightThatIsSeenAsABodyIsFoundAndHidesWhatIsBehindIt() {
        Scene scene = SCENE.plus(Light.at(3, 3, 3)).plus(SphereLight.of(new Vec3(0, 0, 3), 0.5));
        Pick pick = Pick.at(RenderScene.of(scene), scene.settings(), 16.5, 12.5).orElseThrow();
        assertThat(pick.place()).isEqualTo(ScenePath.light(1));
        assertThat(pick.distance()).isCloseTo(1.5, Offset.offset(1e-12));
        Scene unseen = SCENE.plus(SphereLight.of(new Vec3(0, 0, 3), 0.5).withVisible(false));
        assertThat(Pick.at(RenderScene.of(unseen), unseen.settings(), 16.5, 12.5).orElseThrow().place()).isEqualTo(ScenePath.body(1, 1, 1));
        Scene behind = SCENE.plus(SphereLight.of(new Vec3(0, 0, -9), 0.5));
        assertThat(Pick.at(RenderScene.of(behind), behind.settings(), 16.5, 12.5).orElseThrow().place()).isEqualTo(ScenePath.body(1, 1, 1));
    }

    @Test
    void nothingIsFoundWhereTheBackgroundIsSeen() {
        assertThat(Pick.at(RenderScene.of(SCENE), SCENE.settings(), 0.5, 0.5)).isEmpty();
    }
}
