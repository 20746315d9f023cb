package cz.paprsek.scene;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Sphere;
import cz.paprsek.teach.PlainTracer;
import cz.paprsek.teach.mistake.Mistakes;
import cz.paprsek.warning.SceneWarnings;
import cz.paprsek.xml.SceneFiles;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What is hidden is as if it were not there; where a pivot is, pictures do not show. */
class HiddenTest {
    private static final Scene EMPTY = Scene.EMPTY.withSettings(new RenderSettings(40, 30, 4, 1)).withAmbient(new Rgb(60, 60, 60))
            .withCamera(Camera.lookingAt(new Vec3(0, 1, 5), Vec3.ZERO)).plus(Light.at(3, 5, 4));
    private static final SceneObject BALL = SceneObject.of(new Sphere(1)).named("ball").madeOf(Material.color(new Rgb(200, 80, 40)));
    private static final SceneObject GLASS = SceneObject.of(new Sphere(0.5)).named("glass").at(0, 0, 1.5).madeOf("glass");
    private static final SceneObject FLOOR = SceneObject.of(new Plane()).named("floor").at(0, -1, 0);

    private static Operand ball(double x) {
        return Operand.of(new Sphere(0.8)).at(x, 0, 0).madeOf(Material.color(new Rgb(40, 160, 80)));
    }

    private static Operand hidden(Operand operand) {
        return Body.of(operand).hidden(true).toOperand();
    }

    private static Scene of(Csg csg) {
        return EMPTY.plus(FLOOR, SceneObject.of(csg));
    }

    /** A scene with something hidden, and the same without that. */
    private record Pair(Scene with, Scene without) {}

    static Stream<Pair> pairs() {
        Operand box = Operand.of(new Block(new Vec3(-0.5, -0.5, -1), new Vec3(0.5, 0.5, 1)));
        return Stream.of(
                new Pair(EMPTY.plus(BALL, GLASS.hidden(true), FLOOR), EMPTY.plus(BALL, FLOOR)),
                new Pair(EMPTY.plus(BALL, GLASS, FLOOR.hidden(true)), EMPTY.plus(BALL, GLASS)),
                new Pair(of(Csg.difference(ball(0), hidden(box), ball(0.9))), of(Csg.difference(ball(0), ball(0.9)))),
                new Pair(of(Csg.difference(hidden(ball(0)), box)), EMPTY.plus(FLOOR)),
                new Pair(of(Csg.intersection(hidden(ball(5)), ball(0), ball(0.5))), of(Csg.intersection(ball(0), ball(0.5)))),
                new Pair(of(Csg.union(ball(0), Operand.of(Csg.difference(hidden(box), ball(0))))), of(Csg.union(ball(0)))),
                new Pair(of(Csg.intersection(ball(0), Operand.of(Csg.union(hidden(box), hidden(ball(0)))))), of(Csg.intersection(ball(0)))),
                new Pair(of(Csg.union(hidden(ball(0)), hidden(box))), EMPTY.plus(FLOOR)));
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void whatIsHiddenIsAsIfItWereNotThere(Pair pair) throws Exception {
        assertThat(pair.with().shown()).isEqualTo(pair.without());
        assertThat(pair.without().shown()).isSameAs(pair.without());
        assertThat(Renderer.render(pair.with()).toArgb()).as("picture").isEqualTo(Renderer.render(pair.without()).toArgb());
        Scene paths = pair.with().withSettings(pair.with().settings().withIntegrator(Integrator.PATH).withSamples(4));
        assertThat(Renderer.render(paths).toArgb()).as("paths").isEqualTo(Renderer.render(paths.shown()).toArgb());
        assertThat(Renderer.render(SceneFiles.parse(SceneFiles.format(pair.with()))).toArgb()).as("through a file").isEqualTo(Renderer.render(pair.without()).toArgb());
        StringBuilder with = new StringBuilder();
        StringBuilder without = new StringBuilder();
        assertThat(PovFiles.write(pair.with(), with)).isEqualTo(PovFiles.write(pair.without(), without));
        assertThat(with).hasToString(without.toString());
    }

    @Test
    void nothingHiddenCountsForWarningsLightsAndThePlainTracer() {
        SceneObject around = SceneObject.of(new Sphere(9)).named("around").hidden(true);
        SceneObject lamp = SceneObject.of(new Sphere(1)).at(0, 3, 0).madeOf(Material.DEFAULT.withEmission(Rgb.WHITE, 5));
        Scene scene = EMPTY.plus(BALL, around);
        assertThat(SceneWarnings.of(scene)).isEmpty();
        assertThat(SceneWarnings.of(scene.withObjects(List.of(BALL, around.hidden(false))))).isNotEmpty();
        Scene lit = EMPTY.withLights(List.of()).withSettings(EMPTY.settings().withIntegrator(Integrator.PATH).withSamples(4)).plus(BALL, lamp.hidden(true));
        assertThat(Renderer.render(lit).toArgb()).isEqualTo(Renderer.render(lit.shown()).toArgb());
        assertThat(PlainTracer.of(scene, scene.settings(), Mistakes.NONE).light(20, 15, 1000).orElseThrow())
                .isEqualTo(PlainTracer.of(scene.shown(), scene.settings(), Mistakes.NONE).light(20, 15, 1000).orElseThrow());
    }

    /** What has no name is animated by its number, which would be another one's. */
    @Test
    void whatIsHiddenMayMove() {
        Scene scene = EMPTY.plus(GLASS.hidden(true), SceneObject.of(new Sphere(0.3)), SceneObject.of(new Sphere(1)), FLOOR);
        Animation unseen = new Animation("glass", "position", Animation.Turning.ANGLES, List.of(new Animation.Key(0, "0 0 1.5", Animation.Ease.LINEAR)));
        Animation seen = new Animation("sphere#3", "radius", Animation.Turning.ANGLES, List.of(new Animation.Key(0, "2", Animation.Ease.LINEAR)));
        Scene moving = scene.withAnimations(List.of(unseen, seen));
        assertThat(moving.shown()).isEqualTo(scene.shown());
        assertThat(moving.at(0).shown().objects().get(1).shape()).isEqualTo(new Sphere(2));
        assertThat(Renderer.render(moving).toArgb()).isEqualTo(Renderer.render(scene.shown()).toArgb());
    }

    @Test
    void whatIsShownAgainOrHiddenInALivePictureIsAsRenderedAnew() {
        Scene scene = EMPTY.plus(BALL, GLASS, FLOOR);
        RenderScene live = RenderScene.of(scene);
        for (Scene next : List.of(scene.withObjects(List.of(BALL, GLASS.hidden(true), FLOOR)), scene, scene.withObjects(List.of(BALL.hidden(true), GLASS, FLOOR)))) {
            live = live.changedTo(next, RenderMonitor.NONE);
            assertThat(Renderer.render(live, RenderOptions.of(next.settings()), RenderMonitor.NONE).image().toArgb()).isEqualTo(Renderer.render(next).toArgb());
        }
    }

    @Test
    void pivotAndHiddenAreReadWrittenAndSaidByRepeatsAndInstances() throws Exception {
        Scene scene = SceneFiles.parse("""
                <scene xmlns="urn:paprsek:scene:1">
                  <param name="p" value="2"/>
                  <define name="pin"><cylinder radius="0.1" height="1" pivot="0 1 0"/></define>
                  <camera position="0 1 5" target="0 0 0"/>
                  <repeat count="2" position="1 0 0" hidden="true"><sphere radius="0.5"/></repeat>
                  <instance of="pin" hidden="true" position="{p} 0 0"/>
                  <instance of="pin" pivot="0 {p} 0"/>
                  <union hidden="false"><repeat count="2" position="1 0 0" hidden="true"><sphere radius="0.5" pivot="0 0 1"/></repeat><block min="0 0 0" max="1 1 1"/></union>
                </scene>""");
        assertThat(scene.objects()).extracting(SceneObject::hidden).containsExactly(true, true, true, false, false);
        assertThat(scene.objects().get(2).pivot()).isEqualTo(new Placement.Point(new Vec3(0, 1, 0)));
        assertThat(scene.objects().get(3).pivot()).isEqualTo(new Placement.Point(new Vec3(0, 2, 0)));
        assertThat(ScenePath.body(4, 0).in(scene).hidden()).isTrue();
        assertThat(ScenePath.body(4, 0, 1).in(scene).pivot()).isEqualTo(new Placement.Point(new Vec3(0, 0, 1)));
        assertThat(SceneFiles.parse(SceneFiles.format(scene.withRecipe(Scene.Recipe.NONE))).objects()).isEqualTo(scene.objects());
    }

    @Test
    void aPivotIsTheMiddleOfTheBoxUnlessGivenAndOfWhatHasNoEndItsOrigin() {
        Csg bowl = Csg.difference(ball(2), Operand.of(new Block(Vec3.ZERO, Vec3.ONE)));
        assertThat(Placement.MIDDLE.of(bowl)).isEqualTo(new Vec3(2, 0, 0));
        assertThat(Placement.MIDDLE.of(new Plane())).isEqualTo(Vec3.ZERO);
        assertThat(Placement.MIDDLE.of(Csg.union(hidden(ball(2))))).isEqualTo(Vec3.ZERO);
        assertThat(new Placement.Point(Vec3.ONE).of(bowl)).isEqualTo(Vec3.ONE);
    }
}
