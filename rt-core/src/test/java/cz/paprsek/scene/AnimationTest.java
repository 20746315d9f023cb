package cz.paprsek.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Animation.Ease;
import cz.paprsek.scene.Animation.Turning;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.outline.Way;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is where at which time, against what can be worked out by hand. */
class AnimationTest {
    private static final double ROUNDING = 1e-12;

    private static Animation of(String target, String attribute, Ease ease, String... values) {
        return new Animation(target, attribute, Turning.ANGLES, IntStream.range(0, values.length).mapToObj(i -> new Animation.Key(2 * i, values[i], ease)).toList());
    }

    private static double[] at(Ease ease, double t) {
        return of("x", "radius", ease, "1", "5", "2", "9").at(t);
    }

    @ParameterizedTest
    @CsvSource({"-3, 1", "0, 1", "0.5, 2", "1, 3", "2, 5", "3, 3.5", "6, 9", "60, 9"})
    void linearIsEvenBetweenKeysAndHeldOutside(double t, double value) {
        assertThat(at(Ease.LINEAR, t)).containsExactly(value);
    }

    @ParameterizedTest
    @CsvSource({"0.5, 1.625", "1, 3", "1.5, 4.375", "2, 5", "7, 9"})
    void smoothIsThreeUSquaredMinusTwoUCubed(double t, double value) {
        assertThat(at(Ease.SMOOTH, t)).containsExactly(value);
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "1.99, 1", "2, 5", "5.99, 2", "6, 9"})
    void holdStaysUntilTheNextKey(double t, double value) {
        assertThat(at(Ease.HOLD, t)).containsExactly(value);
    }

    @Test
    void alongAnArcTheSpeedIsTheSameEverywhereAndTheNoseIsAhead() throws SceneFileException {
        Scene scene = SceneFiles.parse("""
                <scene xmlns="urn:paprsek:scene:1"><camera position="0 5 9" target="0 0 0"/><sphere name="ship" radius="1"/>
                <animate target="ship" attribute="position" path="M 3 0 A 3 3 0 1 1 -3 0 A 3 3 0 0 1 3 0"><key t="0" value="0 1"/><key t="8" value="1 5"/></animate>
                <animate target="ship" attribute="rotation" path="M 3 0 A 3 3 0 1 1 -3 0 A 3 3 0 0 1 3 0"><key t="0" value="0"/><key t="8" value="1"/></animate></scene>
                """);
        for (double t = 0; t <= 8; t += 0.25) {
            double angle = Math.PI * t / 4;
            Affine ship = scene.at(t).objects().get(0).placement().toParent();
            assertThat(ship.point(Vec3.ZERO).minus(new Vec3(3 * Math.cos(angle), 1 + t / 2, 3 * Math.sin(angle))).length()).as("at %s", t).isLessThan(1e-9);
            assertThat(ship.direction(new Vec3(0, 0, 1)).minus(new Vec3(-Math.sin(angle), 0, Math.cos(angle))).length()).as("at %s", t).isLessThan(1e-9);
        }
        assertThat(SceneFiles.parse(SceneFiles.format(scene))).isEqualTo(scene);
    }

    /** Many pieces by many keys: twenty million pieces, if each key had the path measured. */
    @Test
    void aPathIsMeasuredOnceHoweverManyKeysThereAre() {
        Scene scene = Scene.EMPTY.withObjects(List.of(new SceneObject("ball", new Sphere(1), Placement.NONE, Material.DEFAULT)));
        List<Animation.Key> keys = IntStream.range(0, 2000).mapToObj(i -> new Animation.Key(i, Double.toString(i / 2000.0), Ease.LINEAR)).toList();
        Animation along = new Animation("ball", "position", Turning.ANGLES, "M 0 0" + " h 1 v 1".repeat(5000), keys);
        Scene moving = assertTimeoutPreemptively(Duration.ofSeconds(8), () -> scene.withAnimations(List.of(along)));
        assertThat(moving.at(1000).objects().get(0).placement().toParent().point(Vec3.ZERO)).isEqualTo(new Vec3(2500, 0, 2500));
    }

    @Test
    void alongCurvesSharesAreLengths() {
        Way curve = Way.of("animate", "M 0 0 C 0 4 1 0 5 0 L 9 0 A 2 2 0 0 0 11 -2");
        double step = curve.length() / 400;
        double[] before = curve.at(0);
        for (int i = 1; i <= 400; i++) {
            double[] next = curve.at(i / 400.0);
            assertThat(Math.hypot(next[0] - before[0], next[1] - before[1])).as("step %s", i).isBetween(step * 0.99, step * (1 + 1e-9));
            assertThat(Math.hypot(next[2], next[3])).isEqualTo(1, within(1e-12));
            before = next;
        }
        assertThat(before[0]).isEqualTo(11, within(1e-9));
        assertThat(Way.of("animate", "M 0 0 H 4 V 3").length()).isEqualTo(7, within(ROUNDING));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "position | M 0 0 L 1 1 M 3 3 L 4 4 | 0 | animate path must be one curve, but has 2",
            "position | X | 0 | animate path must have one of the commands M L H V C S Q T A Z at character 1, but has 'X'",
            "radius | M 0 0 L 1 1 | 0 | only what has three numbers goes along a path, not radius",
            "rotation | M 0 0 L 1 1 | 0 1 | of rotation, keys along a path say only how far, one number, but have 2",
            "position | M 0 0 L 1 1 | 0 1 2 | along a path, value must be one number, the share of its length, or two, that and the height, but has 3"})
    void whatGoesAlongNoPathIsToldInASentence(String attribute, String path, String value, String sentence) {
        Scene scene = Scene.EMPTY.withObjects(List.of(new SceneObject("ball", new Sphere(1), Placement.NONE, Material.DEFAULT)));
        assertThatIllegalArgumentException().isThrownBy(() ->
                scene.withAnimations(List.of(new Animation("ball", attribute, Turning.ANGLES, path, List.of(new Animation.Key(0, value, Ease.LINEAR)))))).withMessage(sentence);
    }

    @Test
    void catmullRomIsThePublishedCubicBetweenEvenKeys() {
        for (double u = 0; u < 1; u += 1.0 / 16) {
            double expected = 0.5 * (2 * 5 + (2 - 1) * u + (2 * 1 - 5 * 5 + 4 * 2 - 9) * u * u + (3 * 5 - 1 - 3 * 2 + 9) * u * u * u);
            assertThat(at(Ease.CATMULL_ROM, 2 + 2 * u)[0]).isEqualTo(expected, within(ROUNDING));
        }
    }

    @Test
    void catmullRomThroughUnevenKeysOfAnEvenMotionIsThatMotion() {
        Animation even = new Animation("x", "radius", Turning.ANGLES, List.of(new Animation.Key(0, "3", Ease.CATMULL_ROM), new Animation.Key(0.5, "4", Ease.CATMULL_ROM), new Animation.Key(3, "9", Ease.CATMULL_ROM), new Animation.Key(4, "11", Ease.HOLD)));
        for (double t = 0; t <= 4; t += 0.25) {
            assertThat(even.at(t)[0]).isEqualTo(3 + 2 * t, within(ROUNDING));
        }
    }

    /** The angle of a rotation, in degrees, by the trace of its matrix. */
    private static double angle(Affine rotation) {
        return Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, (rotation.xx() + rotation.yy() + rotation.zz() - 1) / 2))));
    }

    private static Affine rotation(double[] degrees) {
        return Affine.rotation(new Vec3(degrees[0], degrees[1], degrees[2]));
    }

    @Test
    void theShortestTurnIsAboutOneAxisAndEven() {
        Random random = new Random(7);
        for (int i = 0; i < 300; i++) {
            String from = random.nextInt(720) - 360 + " " + (i % 5 == 0 ? 90 : random.nextInt(720) - 360) + " " + (random.nextInt(720) - 360);
            String to = random.nextInt(720) - 360 + " " + (random.nextInt(720) - 360) + " " + (i % 7 == 0 ? 180 : random.nextInt(720) - 360);
            Animation turn = new Animation("x", "rotation", Turning.SHORTEST, List.of(new Animation.Key(0, from, Ease.LINEAR), new Animation.Key(1, to, Ease.LINEAR)));
            Affine start = rotation(turn.at(0));
            double whole = angle(start.inverse().after(rotation(turn.at(1))));
            assertThat(whole).isLessThanOrEqualTo(180);
            for (double t : new double[] {0.25, 0.5, 0.875}) {
                assertThat(angle(start.inverse().after(rotation(turn.at(t))))).as(from + " to " + to).isEqualTo(t * whole, within(2e-5));
            }
        }
        Animation across = new Animation("x", "rotation", Turning.SHORTEST, List.of(new Animation.Key(0, "0 350 0", Ease.LINEAR), new Animation.Key(1, "0 10 0", Ease.LINEAR)));
        assertThat(across.at(0.25)[1]).isEqualTo(-5, within(1e-9));
        assertThat(of("x", "rotation", Ease.LINEAR, "0 350 0", "0 10 0").at(0.5)).containsExactly(0, 265, 0);
    }

    @Test
    void everyNumberVectorAndColourCanBeAnimatedAndIsWhatItIs() {
        int tried = 0;
        for (Scene scene : SceneFiles.examples().scenes()) {
            Scene named = scene.withAnimations(List.of()).withRecipe(Scene.Recipe.NONE);
            for (ScenePath place : ScenePath.bodies(named).filter(at -> at.depth() == 0).limit(40).toList()) {
                Body body = ((ScenePath.BodyAt) place).in(named);
                for (Record record : List.of(body.placement(), (Record) body.shape())) {
                    for (Described one : Described.inline(record.getClass())) {
                        if (one.isOf(record) && isNumbers(one.says().value())) {
                            Animation animation = of(place.text(named), one.name(), Ease.LINEAR, text(one.value(record)));
                            // Which of both zeros it is does not matter.
                            assertThat(((ScenePath.BodyAt) place).in(named.withAnimations(List.of(animation)).at(1)).toString().replace("-0.0", "0.0"))
                                    .isEqualTo(body.toString().replace("-0.0", "0.0"));
                            tried++;
                        }
                    }
                }
            }
        }
        assertThat(tried).isGreaterThan(300);
    }

    private static boolean isNumbers(Kind kind) {
        return switch (kind.form()) {
            case NUMBER, WHOLE, VECTOR, PAIR, SCALE, COLOR -> true;
            default -> false;
        };
    }

    private static String text(Object value) {
        return value instanceof Vec3 v ? v.x() + " " + v.y() + " " + v.z() : value instanceof Rgb c ? c.red() + " " + c.green() + " " + c.blue()
                : value instanceof double[] two ? Arrays.stream(two).mapToObj(String::valueOf).collect(Collectors.joining(" ")) : String.valueOf(value);
    }

    private static final Scene SCENE = Scene.EMPTY.plus(SceneObject.of(new Sphere(1)).named("ball"), SceneObject.of(new Sphere(2)).at(5, 0, 0).named("other"))
            .plus(Light.at(0, 5, 0).named("lamp")).plus("paint", cz.paprsek.material.Material.color(10, 20, 30))
            .withCamera(Camera.lookingAt(new Vec3(0, 0, 9), Vec3.ZERO).named("eye"));

    @Test
    void allThatMovesIsMovedAndNothingElseIsTouched() {
        Scene moving = SCENE.withAnimations(List.of(of("ball", "position", Ease.LINEAR, "0 0 0", "4 2 0"), of("ball", "radius", Ease.LINEAR, "1", "3"),
                of("camera:eye", "target", Ease.LINEAR, "0 0 0", "2 0 0"), of("camera:eye", "fovy", Ease.LINEAR, "40", "60"), of("camera:eye", "aperture", Ease.LINEAR, "0", "1"),
                of("light:lamp", "color", Ease.LINEAR, "255 255 255", "255 55 5"), of("material:paint", "color", Ease.LINEAR, "10 20 30", "20 20 40")));
        Scene then = moving.at(1);
        assertThat(then.objects().get(0)).isEqualTo(SceneObject.of(new Sphere(2)).at(2, 1, 0).named("ball"));
        assertThat(then.objects().get(1)).isSameAs(SCENE.objects().get(1));
        assertThat(then.camera()).isEqualTo(new Camera("eye", new Vec3(0, 0, 9), new Camera.Target(new Vec3(1, 0, 0)), Vec3.Y, new Lens.Perspective(50, 0.5, 0)));
        assertThat(then.lights()).containsExactly(Light.at(0, 5, 0).named("lamp").withColor(new Rgb(255, 155, 130)));
        assertThat(then.materials()).isEqualTo(Map.of("paint", cz.paprsek.material.Material.color(15, 20, 35)));
        assertThat(then.animations()).isEmpty();
        assertThat(moving.withAnimations(List.of())).isEqualTo(SCENE);
    }

    /** Who looks through another camera has it first; what moves by its number stays the same one. */
    @Test
    void whatMovesIsTheSameCameraThroughWhicheverOneLooks() throws Exception {
        Scene scene = SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 5' target='0 0 0'/><camera name='plan' projection='orthographic' height='4' position='0 9 0' target='0 0 0'/>"
                + "<camera position='5 0 0' target='0 0 0'/><sphere radius='1'/><animate target='camera:#1' attribute='fovy'><key t='0' value='33'/></animate></scene>");
        Scene plan = scene.through("plan").at(0);
        assertThat(plan.cameras().get(1).lens()).isInstanceOfSatisfying(Lens.Perspective.class, lens -> assertThat(lens.fovy()).isEqualTo(33));
        assertThat(plan.cameras().get(2)).isEqualTo(scene.cameras().get(2));
        assertThat(scene.through(2).at(0).cameras()).containsExactly(scene.cameras().get(2), scene.at(0).camera(), scene.cameras().get(1));
        assertThat(scene.through(0)).isEqualTo(scene);
    }

    @Test
    void aFlightOfTheCameraTouchesNoBody() {
        Scene flight = SCENE.withAnimations(List.of(of("camera:eye", "position", Ease.SMOOTH, "0 0 9", "9 0 9")));
        assertThat(flight.at(0.7).objectsOtherThanIn(flight)).isEmpty();
        assertThat(flight.at(0.7).lights()).isSameAs(SCENE.lights());
    }

    @Test
    void aValueThatIsNoneBetweenTheKeysIsRefusedWhenItsTimeComes() {
        Scene scene = SCENE.withAnimations(List.of(of("ball", "radius", Ease.CATMULL_ROM, "9", "0.1", "0.1", "9")));
        assertThatIllegalArgumentException().isThrownBy(() -> scene.at(3)).withMessageStartingWith("sphere radius must be a finite number above 0");
    }

    /** Of very many objects, and changed where nothing moves, an animated scene costs no more than a still one; what it is of is checked again when that changes. */
    @Test
    void whatIsAnimatedIsCheckedWhenItChangesAndOnlyThen() {
        SceneObject[] many = IntStream.range(0, 2000).mapToObj(i -> SceneObject.of(new Sphere(1)).named(i == 7 ? "ball" : "")).toArray(SceneObject[]::new);
        Scene scene = Scene.EMPTY.withCameras(List.of(Camera.DEFAULT.named("eye"))).plus(many)
                .withAnimations(List.of(of("ball", "radius", Ease.LINEAR, "1", "3"), of("camera:eye", "fovy", Ease.LINEAR, "20", "40"), of("sphere#3", "radius", Ease.LINEAR, "1", "2")));
        assertThat(scene.withName("x").withSettings(scene.settings().withFps(7)).animations()).isSameAs(scene.animations());
        assertThatIllegalArgumentException().isThrownBy(() -> scene.withCameras(List.of(Camera.DEFAULT))).withMessageContaining("camera:eye");
        assertThatIllegalArgumentException().isThrownBy(() -> scene.withObjects(List.of(many[0]))).withMessageContaining("ball");
        assertThat(((Sphere) scene.moments().apply(1).objects().get(7).shape()).radius()).isEqualTo(2);
        assertThat(((Sphere) scene.at(1).objects().get(2).shape()).radius()).isEqualTo(1.5);
        assertThat(scene.at(1)).isEqualTo(scene.moments().apply(1));
    }
}
