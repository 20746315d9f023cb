package cz.paprsek.fx.model.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Structure;
import cz.paprsek.fx.model.motion.Keys.KeyAt;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Animation.Ease;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Keys, times, ways and turntables, without a window. */
class KeysTest {
    private static final String HEAD = "<scene xmlns=\"urn:paprsek:scene:1\"><camera position=\"0 2 8\" target=\"0 1 0\"/>";

    private final Scene scene = scene("<sphere name=\"ball\" radius=\"1\" position=\"0 1 0\"/>");

    private static Scene scene(String bodies) {
        try {
            return SceneFiles.parse(HEAD + bodies + "</scene>");
        } catch (SceneFileException wrong) {
            throw new AssertionError(wrong);
        }
    }

    @Test
    void keysAreAddedMovedEasedValuedAndRemoved() {
        ScenePath ball = ScenePath.body(0);
        Scene two = Keys.added(Keys.added(scene, ball, "position", 0, "0 1 0"), ball, "position", 2, "4 1 0");
        assertThat(two.at(1).objects().get(0).placement().position()).isEqualTo(new Vec3(2, 1, 0));
        Scene eased = Keys.eased(two, new KeyAt(0, 0), Ease.HOLD);
        assertThat(eased.at(1.9).objects().get(0).placement().position()).isEqualTo(new Vec3(0, 1, 0));
        Scene later = Keys.moved(eased, new KeyAt(0, 0), 3);
        assertThat(later.animations().get(0).keys()).extracting(Animation.Key::t).containsExactly(2.0, 3.0);
        assertThat(Keys.moved(two, new KeyAt(0, 0), 2).animations().get(0).keys()).as("it takes the place of the other").hasSize(1);
        assertThat(Keys.valued(two, new KeyAt(0, 1), "8 1 0").at(1).objects().get(0).placement().position()).isEqualTo(new Vec3(4, 1, 0));
        assertThat(Keys.removed(Keys.removed(two, new KeyAt(0, 0)), new KeyAt(0, 0))).as("the animation goes with its last key").isEqualTo(scene);
    }

    @Test
    void theTracksOfWhatIsSelectedAreShownOrAll() {
        Scene both = Keys.added(Keys.added(scene, ScenePath.camera(), "fovy", 0, "40"), ScenePath.body(0), "radius", 0, "1");
        assertThat(Keys.tracks(both, Set.of())).containsExactly(0, 1);
        assertThat(Keys.tracks(both, Set.of(ScenePath.body(0)))).containsExactly(1);
    }

    @Test
    void whatIsEditedIsSeen() {
        EditorModel model = new EditorModel(Scene.EMPTY);
        Clock clock = new Clock(model);
        model.open(scene);
        assertThat(clock.openProperty().get()).isFalse();
        model.edit(Label.of(Label.Edit.CHANGE), now -> Keys.added(Keys.added(now, ScenePath.body(0), "position", 0, "0 1 0"), ScenePath.body(0), "position", 4, "4 1 0"));
        assertThat(clock.openProperty().get()).as("what is animated first opens the timeline").isTrue();
        assertThat(clock.span()).isEqualTo(new Clock.Span(1, 101));
        clock.lookAtFrame(51);
        assertThat(clock.shown().scene().objects().get(0).placement().position()).isEqualTo(new Vec3(2, 1, 0));
        model.edit(Label.of(Label.Edit.CHANGE), now -> now.withAmbient(new Rgb(9, 9, 9)));
        assertThat(clock.secondsProperty().get()).as("seen at this time too").isPresent();
        model.edit(Label.of(Label.Edit.MOVE), now -> now.with(ScenePath.body(0), body -> body.placed(body.placement().withPosition(new Vec3(0, 3, 0)))));
        assertThat(clock.secondsProperty().get()).as("what is moved is not seen but at rest").isEmpty();
        assertThat(clock.shown()).isSameAs(model.state());
    }

    @Test
    void formulasKnowTheTimeThatIsLookedAt() {
        EditorModel model = new EditorModel(Scene.EMPTY);
        Clock clock = new Clock(model);
        model.open(scene("<sphere radius=\"1\" position=\"{2*t} 1 0\"/>"));
        assertThat(clock.openProperty().get()).isTrue();
        clock.look(1.5);
        assertThat(clock.shown().scene().objects().get(0).placement().position().x()).isEqualTo(3);
    }

    @Test
    void aWayLeadsThroughTheOperationsAround() {
        Scene moved = scene("<union name=\"u\" rotation=\"0 90 0\"><sphere name=\"a\" radius=\"1\"/><sphere radius=\"1\" position=\"3 0 0\"/></union>"
                + "<animate target=\"u/a\" attribute=\"position\"><key t=\"0\" value=\"0 0 0\"/><key t=\"1\" value=\"0 0 2\"/></animate>");
        Ways.Way way = Ways.of(moved).get(0);
        assertThat(way.keys()).hasSize(2);
        assertThat(way.keys().get(1).minus(new Vec3(2, 0, 0)).length()).isLessThan(1e-12);
    }

    @Test
    void whatIsInAnOperationThatWasNeverMovedIsFreedWithItsPath() {
        Scene along = scene("<union name=\"u\"><sphere name=\"a\" radius=\"1\"/><sphere radius=\"1\" position=\"3 0 0\"/></union>"
                + "<animate target=\"u/a\" attribute=\"position\" path=\"M 0 0 L 1 0 L 1 1\"><key t=\"0\" value=\"0\"/><key t=\"1\" value=\"1\"/></animate>");
        Scene freed = Structure.dissolve(EditorState.of(along), Set.of(ScenePath.body(0))).scene();
        assertThat(Ways.at(freed.at(0.7), ScenePath.body(0))).isEqualTo(Ways.at(along.at(0.7), ScenePath.body(0, 0)));
    }

    @Test
    void manyWaysShareTheirPoints() {
        StringBuilder bodies = new StringBuilder();
        for (int i = 0; i < 100; i++) {
            bodies.append("<sphere name=\"s").append(i).append("\" radius=\"1\"/>");
        }
        for (int i = 0; i < 100; i++) {
            bodies.append("<animate target=\"s").append(i).append("\" attribute=\"position\"><key t=\"0\" value=\"0 0 0\"/><key t=\"").append(1 + i).append("\" value=\"0 0 2\"/></animate>");
        }
        List<Ways.Way> ways = Ways.of(scene(bodies.toString()));
        assertThat(ways).hasSize(100).allSatisfy(way -> {
            assertThat(way.keys()).containsExactly(Vec3.ZERO, new Vec3(0, 0, 2));
            assertThat(way.line()).hasSizeBetween(8, 41).startsWith(Vec3.ZERO).endsWith(new Vec3(0, 0, 2));
        });
    }

    @Test
    void aCameraGoesRoundInACircleWithoutAnEnd() {
        EditorState round = Turntable.camera(EditorState.of(scene));
        for (int frame = 0; frame <= Turntable.FRAMES; frame++) {
            Vec3 eye = round.scene().at(round.scene().settings().seconds(frame + 1)).camera().position();
            double angle = 2 * Math.PI * frame / Turntable.FRAMES;
            assertThat(eye.minus(new Vec3(8 * Math.sin(angle), 2, 8 * Math.cos(angle))).length()).as("frame %s", frame).isLessThan(8e-4);
            assertThat(Math.hypot(eye.x(), eye.z())).as("frame %s", frame).isCloseTo(8, within(1.6e-4));
        }
    }

    @Test
    void bodiesTurnAboutTheirMiddlesWhereverTheirOriginIs() {
        Scene off = scene("<block name=\"b\" min=\"2 0 0\" max=\"4 2 2\"/><sphere name=\"s\" radius=\"1\" position=\"0 1 0\"/>");
        Scene turned = Turntable.bodies(off, List.of(ScenePath.body(0), ScenePath.body(1)));
        Vec3 middle = new Vec3(3, 1, 1);
        for (double t : new double[] {0, 0.5, 1, 1.7, 3.3, 4}) {
            Scene moment = turned.at(t);
            assertThat(ScenePath.body(0).toWorld(moment).point(middle).minus(middle).length()).as("at %s", t).isLessThan(1e-3);
            Vec3 corner = ScenePath.body(0).toWorld(moment).point(new Vec3(4, 1, 1)).minus(middle);
            assertThat(corner.minus(new Vec3(Math.cos(Math.PI * t / 2), 0, -Math.sin(Math.PI * t / 2))).length()).as("at %s", t).isLessThan(1e-3);
        }
        assertThat(turned.animations()).filteredOn(one -> one.target().equals("s")).as("no more than it needs").hasSize(1);
    }

    @Test
    void whatIsTakenIntoATurnedGroupGoesTheSameWay() {
        Scene turned = scene("<union name=\"u\" position=\"1 0 0\" rotation=\"0 90 0\" scale=\"2\"><sphere name=\"a\" radius=\"1\"/></union><sphere name=\"b\" radius=\"1\"/>"
                + "<animate target=\"b\" attribute=\"position\"><key t=\"0\" value=\"0 0 0\" ease=\"catmull-rom\"/><key t=\"1\" value=\"3 1 2\" ease=\"smooth\"/><key t=\"2\" value=\"0 5 0\"/></animate>");
        Scene inside = Structure.move(EditorState.of(turned), Set.of(ScenePath.body(1)), Optional.of(ScenePath.body(0)), 1).scene();
        Scene outside = Structure.dissolve(EditorState.of(inside), Set.of(ScenePath.body(0))).scene();
        for (double t = 0; t <= 2; t += 0.25) {
            Vec3 place = Ways.at(turned.at(t), ScenePath.body(1)).orElseThrow();
            assertThat(Ways.at(inside.at(t), ScenePath.body(0, 1)).orElseThrow().minus(place).length()).as("inside at %s", t).isLessThan(1e-9);
            assertThat(Ways.at(outside.at(t), ScenePath.body(1)).orElseThrow().minus(place).length()).as("freed at %s", t).isLessThan(1e-9);
        }
        Scene turning = Keys.added(turned, ScenePath.body(1), "rotation", 0, "0 0 0");
        assertThatIllegalArgumentException().isThrownBy(() -> Structure.move(EditorState.of(turning), Set.of(ScenePath.body(1)), Optional.of(ScenePath.body(0)), 1))
                .withMessageContaining("moves by keys");
    }
}
