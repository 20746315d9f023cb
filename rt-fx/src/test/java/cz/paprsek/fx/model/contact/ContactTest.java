package cz.paprsek.fx.model.contact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.Alignment.Line;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Bodies that touch by their surfaces, where closed forms say. */
class ContactTest {
    private static final double NEAR = 1.5e-6;

    private static Optional<Line> along(Axis axis, double by, double reach, SceneObject... objects) {
        return Contact.with(EditorState.of(Scene.EMPTY.withObjects(List.of(objects))), Set.of(ScenePath.body(0))).along(axis, by, reach);
    }

    /** Its upper face goes through the origin and falls along x. */
    private static SceneObject roof(double degrees) {
        return SceneObject.of(new Block(new Vec3(-90, -1, -90), new Vec3(90, 0, 90))).placed(Placement.NONE.withRotation(new Vec3(0, 0, -degrees)));
    }

    /** A ball lies on a plane if its centre is as far from that as its radius: along the height that is r / cos a above the foot. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 10, 30, 45, 60, 75})
    void aBallTouchesASlopeByItsSurface(double degrees) {
        double r = 0.5;
        double a = Math.toRadians(degrees);
        double y = -Math.tan(a) * 1 + r / Math.cos(a);
        assertThat(along(Axis.Y, y - 5 + 0.05, 0.2, SceneObject.of(new Sphere(r)).at(1, 5, 0.3), roof(degrees))).hasValueSatisfying(line -> {
            assertThat(line.by()).isCloseTo(y - 5, within(NEAR));
            double distance = 1 * Math.sin(a) + (5 + line.by()) * Math.cos(a);
            assertThat(distance).as("of the centre from the plane").isCloseTo(r, within(NEAR));
            assertThat(line.place()).as("where it touches").isCloseTo(y - r * Math.cos(a), within(1e-3));
        });
    }

    /** A plane that is moved along has no end, and hides nothing. */
    @Test
    void aBallTouchesThoughAPlaneIsMovedWithIt() {
        List<SceneObject> objects = List.of(SceneObject.of(new Sphere(0.5)).at(0, 5, 0), SceneObject.of(new Plane()).at(0, -100, 0), roof(0));
        Contact contact = Contact.with(EditorState.of(Scene.EMPTY.withObjects(objects)), Set.of(ScenePath.body(0), ScenePath.body(1)));
        assertThat(contact.along(Axis.Y, -4.45, 0.2)).hasValueSatisfying(line -> assertThat(line.by()).isCloseTo(-4.5, within(NEAR)));
    }

    @Test
    void itIsNotTouchedOutOfReach() {
        assertThat(along(Axis.Y, -3.9, 0.2, SceneObject.of(new Sphere(0.5)).at(0, 5, 0), roof(45))).isEmpty();
    }

    /** The centres of balls that touch are as far from each other as their radii together. */
    @Test
    void aBallTouchesAnotherBesideItsMiddle() {
        SceneObject ball = SceneObject.of(new Sphere(1)).at(0.6, 5, -0.3);
        double y = Math.sqrt(9 - 0.6 * 0.6 - 0.3 * 0.3);
        assertThat(along(Axis.Y, y - 5.1, 0.2, ball, SceneObject.of(new Sphere(2)))).hasValueSatisfying(line -> assertThat(line.by()).isCloseTo(y - 5, within(NEAR)));
        assertThat(along(Axis.Y, -y - 4.9, 0.2, ball, SceneObject.of(new Sphere(2)))).as("from below").hasValueSatisfying(line -> assertThat(line.by()).isCloseTo(-y - 5, within(NEAR)));
        assertThat(along(Axis.X, -3.6, 0.2, ball.at(4, 0, 0), SceneObject.of(new Sphere(2)).at(-2.5, 0, 0))).hasValueSatisfying(line -> assertThat(line.by()).isCloseTo(-3.5, within(NEAR)));
    }

    /** An upright cube on a roof stands on an edge, a tilted one on a corner, a cylinder on a point of its rim. */
    @Test
    void cornersAndRimsTouchFirst() {
        SceneObject cube = SceneObject.of(new Block(new Vec3(-0.5, -0.5, -0.5), new Vec3(0.5, 0.5, 0.5)));
        assertThat(along(Axis.Y, -5.1, 0.2, cube.at(1, 5, 0), roof(45))).hasValueSatisfying(line -> assertThat(line.by()).isCloseTo(-5, within(NEAR)));
        double tan = Math.tan(Math.toRadians(30));
        assertThat(along(Axis.Y, -4.9, 1, SceneObject.of(new Cylinder(0.5, 2)).at(0, 5, 0), roof(30))).hasValueSatisfying(line -> assertThat(line.by()).isCloseTo(0.5 * tan - 5, within(1e-5)));
        // Stood on a corner, its lowest point is half a diagonal below its middle.
        SceneObject onCorner = cube.placed(Placement.at(0, 5, 0).withRotation(new Vec3(45, 0, Math.toDegrees(Math.atan(Math.sqrt(0.5))))));
        assertThat(along(Axis.Y, Math.sqrt(3) / 2 - 5.1, 0.2, onCorner, roof(0))).hasValueSatisfying(line -> assertThat(line.by()).isCloseTo(Math.sqrt(3) / 2 - 5, within(1e-5)));
    }

    /** Of a rod thinner than the space between the lines that are looked along first. */
    @Test
    void whatIsThinIsTouchedToo() {
        SceneObject rod = SceneObject.of(new Block(new Vec3(0.300, -1, -9), new Vec3(0.302, 0, 9)));
        double y = Math.sqrt(1 - 0.3 * 0.3);
        assertThat(along(Axis.Y, y - 5.02, 0.1, SceneObject.of(new Sphere(1)).at(0, 5, 0), rod)).hasValueSatisfying(line -> assertThat(line.by()).isCloseTo(y - 5, within(NEAR)));
    }

    @Test
    void whatIsHiddenIsNotTouched() {
        EditorState state = EditorState.of(Scene.EMPTY.withObjects(List.of(SceneObject.of(new Sphere(1)).at(0, 5, 0), SceneObject.of(new Sphere(1)))));
        assertThat(Contact.with(state, Set.of(ScenePath.body(0))).along(Axis.Y, -3, 0.2)).isPresent();
        assertThat(Contact.with(state.withHidden(Set.of(ScenePath.body(1))), Set.of(ScenePath.body(0))).along(Axis.Y, -3, 0.2)).isEmpty();
    }

    /** No step of the hand may ask more than can be answered at once: {@link Work} and the search that it does not cut short. */
    @ParameterizedTest
    @ValueSource(ints = {1, 30, 180, 450})
    void amongManyAStepStaysShort(int count) {
        List<SceneObject> balls = IntStream.range(0, 900).mapToObj(i -> SceneObject.of(new Sphere(0.5)).at(i % 30 * 1.1, Math.floorDiv(i, 30) % 3 * 0.2, Math.floorDiv(i, 30) * 1.1)).toList();
        EditorState state = EditorState.of(Scene.EMPTY.withObjects(balls).plus(SceneObject.of(new Plane())));
        Contact contact = Contact.with(state, IntStream.range(0, count).mapToObj(i -> ScenePath.body(i * 7 % 900)).collect(Collectors.toSet()));
        long all = 0;
        long most = 0;
        for (Axis axis : Axis.values()) {
            for (int step = 0; step < 20; step++) {
                contact.along(axis, step * 0.09, 0.3);
                most = Math.max(most, contact.asked() - all);
                all = contact.asked();
            }
        }
        assertThat(most).isLessThan(count == 1 ? 5000 : 2 * Work.MOST);
        contact.along(Axis.X, 1, 0);
        assertThat(contact.asked()).as("nothing is nearer than what is there").isEqualTo(all);
    }

    /** What is moved in a plane touches by its surface along one axis, where it has come to along the other. */
    @Test
    void inAPlaneTheOtherAxisStays() {
        SceneObject ball = SceneObject.of(new Sphere(1)).at(-5, 0, -4);
        EditorState state = EditorState.of(Scene.EMPTY.plus(ball, SceneObject.of(new Sphere(2))));
        Contact contact = Contact.with(state, Set.of(ScenePath.body(0)));
        Vec3 chosen = new Vec3(2.2, 0, 2.9);
        double x = 5 - Math.sqrt(9 - 1.1 * 1.1);
        assertThat(contact.inPlane(Axis.X, Axis.Z, new Vec3(x + 0.03, 0, 2.93), chosen, 0.1, 0.005)).hasValueSatisfying(line -> {
            assertThat(line.axis()).isEqualTo(Axis.X);
            assertThat(line.by()).isCloseTo(x, within(NEAR));
        });
        double z = 4 - Math.sqrt(9 - 2.8 * 2.8);
        assertThat(contact.inPlane(Axis.X, Axis.Z, new Vec3(2.22, 0, z - 0.05), chosen, 0.001, 0.1)).hasValueSatisfying(line -> {
            assertThat(line.axis()).isEqualTo(Axis.Z);
            assertThat(line.by()).isCloseTo(z, within(NEAR));
        });
        assertThat(contact.inPlane(Axis.X, Axis.Z, new Vec3(x + 0.03, 0, 2.93), chosen, 0, 0)).isEmpty();
    }

    /** Each step asks for both axes together no more than for one. */
    @Test
    void inAPlaneAStepStaysShortToo() {
        List<SceneObject> balls = IntStream.range(0, 900).mapToObj(i -> SceneObject.of(new Sphere(0.5)).at(i % 30 * 1.1, Math.floorDiv(i, 30) % 3 * 0.2, Math.floorDiv(i, 30) * 1.1)).toList();
        Contact contact = Contact.with(EditorState.of(Scene.EMPTY.withObjects(balls)), IntStream.range(0, 30).mapToObj(i -> ScenePath.body(i * 7)).collect(Collectors.toSet()));
        for (int step = 0; step < 20; step++) {
            long before = contact.asked();
            Vec3 hand = new Vec3(step * 0.09, 0, step * 0.07);
            contact.inPlane(Axis.X, Axis.Z, hand, hand, 0.3, 0.3);
            assertThat(contact.asked() - before).isLessThan(2 * Work.MOST);
        }
    }

    /** A ball beside two rows of balls that move along with it. */
    @Test
    void ofManyTheForemostTouches() {
        List<SceneObject> balls = IntStream.range(0, 300).mapToObj(i -> SceneObject.of(new Sphere(0.5)).at(i % 20, 0, Math.floorDiv(i, 20))).toList();
        EditorState state = EditorState.of(Scene.EMPTY.withObjects(balls).plus(SceneObject.of(new Sphere(0.5)).at(22.3, 0.6, 7)));
        Contact contact = Contact.with(state, IntStream.range(0, 300).mapToObj(ScenePath::body).collect(Collectors.toSet()));
        assertThat(contact.along(Axis.X, 2.45, 0.1)).hasValueSatisfying(line -> assertThat(line.by()).isCloseTo(3.3 - 0.8, within(NEAR)));
    }
}
