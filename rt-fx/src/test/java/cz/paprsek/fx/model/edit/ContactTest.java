package cz.paprsek.fx.model.edit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** A cube above a roof that falls by 45 degrees, and beside a ball. */
class ContactTest {
    private static final SceneObject CUBE = SceneObject.of(new Block(new Vec3(-0.5, -0.5, -0.5), new Vec3(0.5, 0.5, 0.5))).at(1, 5, 0);
    private static final SceneObject ROOF = SceneObject.of(new Block(new Vec3(-9, -1, -9), new Vec3(9, 0, 9))).placed(Placement.NONE.withRotation(new Vec3(0, 0, -45)));
    private static final SceneObject BALL = SceneObject.of(new Sphere(1)).at(-4, 5, 0);
    private final EditorState state = EditorState.of(Scene.EMPTY.withObjects(List.of(CUBE, ROOF, BALL)));
    private final Contact contact = Contact.with(state, Set.of(ScenePath.body(0)));

    @Test
    void itsMiddleComesOntoASlantedFace() {
        // Below (1, 5, 0) the face is at y = -1; half a cube above that the cube touches it there.
        assertThat(contact.along(Axis.Y, -5.4, 0.2)).hasValueSatisfying(line -> {
            assertThat(line.by()).isCloseTo(-5.5, within(1e-6));
            assertThat(line.place()).isCloseTo(-1, within(1e-6));
        });
        assertThat(contact.along(Axis.Y, -5.2, 0.2)).as("out of reach").isEmpty();
    }

    @Test
    void roundThingsAreTouchedToo() {
        assertThat(contact.along(Axis.X, -3.4, 0.2)).hasValueSatisfying(line -> assertThat(line.by()).isCloseTo(-3.5, within(1e-6)));
        assertThat(Contact.with(state.withHidden(Set.of(ScenePath.body(2))), Set.of(ScenePath.body(0))).along(Axis.X, -3.4, 0.2)).as("what is hidden is not touched").isEmpty();
    }
}
