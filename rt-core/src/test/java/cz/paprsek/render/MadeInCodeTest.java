package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import cz.paprsek.image.Image;
import cz.paprsek.material.CustomPattern;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.query.Filter;
import cz.paprsek.query.SceneTables;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.render.explain.text.Decoration;
import cz.paprsek.render.explain.text.TreeText;
import cz.paprsek.render.light.FixedPoints;
import cz.paprsek.scene.CustomLight;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.CustomShape;
import cz.paprsek.shape.CustomSolid;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Solid;
import cz.paprsek.xml.SceneFile;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Shapes, patterns and lights that an embedder makes are rendered, explained and listed like ours; files refuse them with a sentence. */
class MadeInCodeTest {
    private static final Material GLASS = Material.color(255, 255, 255).withDiffusion(0.1).withTransparency(0.8, 1.5).withHighlight(0.5, 50);

    /** A block as an embedder would make it. */
    private record Crate(double half) implements CustomSolid {
        @Override
        public Bounds bounds() {
            return Bounds.around(Vec3.ZERO, new Vec3(half, half, half));
        }

        @Override
        public void cross(Line line) {
            double enter = Double.NEGATIVE_INFINITY;
            double leave = Double.POSITIVE_INFINITY;
            int enterFace = 0;
            int leaveFace = 0;
            for (int axis = 0; axis < 3; axis++) {
                double o = axis == 0 ? line.ox : axis == 1 ? line.oy : line.oz;
                double d = axis == 0 ? line.dx : axis == 1 ? line.dy : line.dz;
                double first = (-Math.copySign(half, d) - o) / d;
                double second = (Math.copySign(half, d) - o) / d;
                if (first > enter) {
                    enter = first;
                    enterFace = 2 * axis + (d > 0 ? 0 : 1);
                }
                if (second < leave) {
                    leave = second;
                    leaveFace = 2 * axis + (d > 0 ? 1 : 0);
                }
            }
            if (enter < leave) {
                line.cross(enter, enterFace);
                line.cross(leave, leaveFace);
            }
        }

        @Override
        public void normal(int face, Hit hit) {
            double side = face % 2 == 0 ? -1 : 1;
            hit.normal(face / 2 == 0 ? side : 0, face / 2 == 1 ? side : 0, face / 2 == 2 ? side : 0);
        }
    }

    /** The checker as an embedder would make it. */
    private record Cubes(double size) implements CustomPattern {
        @Override
        public void color(double x, double y, double z, Hit hit) {
            double grey = (Math.floor(x / size + 1e-9) + Math.floor(y / size + 1e-9) + Math.floor(z / size + 1e-9)) % 2 == 0 ? 1 : 0;
            hit.color(grey, grey, grey);
        }
    }

    private record ByPlace() implements CustomPattern {
        @Override
        public boolean isMapped() {
            return true;
        }

        @Override
        public void color(double x, double y, double z, Hit hit) {
            hit.color(hit.u, hit.v, 0);
        }
    }

    private static Scene around(Solid solid) {
        Placement turned = Placement.at(-0.7, 0, 0).withRotation(new Vec3(20, 30, 40)).withScale(new Vec3(1, 1.2, 0.8));
        return Scenes.empty().plus(Light.at(3, 6, 9)).plus(
                SceneObject.of(solid).placed(turned).madeOf(GLASS),
                SceneObject.of(Csg.difference(Operand.of(solid), Operand.of(solid).at(0.4, 0.5, 0.6))).named("cut").at(1, 0, 0)
                        .madeOf(Material.color(200, 90, 60).withReflection(0.2)));
    }

    @Test
    void aSolidMadeInCodeLooksAsOursOfTheSameForm() {
        Image ours = Renderer.render(around(new Block(new Vec3(-0.6, -0.6, -0.6), new Vec3(0.6, 0.6, 0.6))));
        Image own = Renderer.render(around(new Crate(0.6)));
        double farthest = 0;
        for (int i = 0; i < ours.width() * ours.height(); i++) {
            int x = i % ours.width();
            int y = i / ours.width();
            farthest = Math.max(farthest, Math.max(Math.abs(own.red(x, y) - ours.red(x, y)), Math.abs(own.blue(x, y) - ours.blue(x, y))));
        }
        assertThat(farthest).isLessThan(1e-6);
        assertThat(IntStream.of(ours.toArgb()).distinct().count()).as("something to see").isGreaterThan(20);
    }

    @Test
    void aPatternMadeInCodeLooksAsOursOfTheSameForm() {
        assertThat(Renderer.render(patterned(new Cubes(0.3))).toArgb())
                .isEqualTo(Renderer.render(patterned(new Pattern.Checker(0.3, Vec3.ZERO, Rgb.WHITE, Rgb.BLACK))).toArgb());
    }

    private static Scene patterned(Pattern pattern) {
        return Scenes.empty().plus(Light.at(3, 6, 9)).plus(SceneObject.of(new Block(new Vec3(-1, -1, -1), new Vec3(1, 1, 1)))
                .rotated(20, 30, 40).madeOf(Material.DEFAULT.withPattern(pattern)));
    }

    @Test
    void aPatternIsToldThePlaceInThePictureIfItAsks() {
        Scene scene = patterned(new ByPlace()).withAmbient(Rgb.WHITE).withLights(List.of());
        var met = RenderScene.of(scene).explain(scene.settings().width() / 2, scene.settings().height() / 2).rays().get(0).encounter().orElseThrow();
        assertThat(met.color().red()).isEqualTo(met.place().u()).isBetween(0.01, 0.99);
        assertThat(met.color().green()).isEqualTo(met.place().v()).isBetween(0.01, 0.99);
    }

    /** A point light as an embedder would make it, looked for as often as told. */
    private record Bulb(Vec3 position, int samples) implements CustomLight {
        @Override
        public boolean sample(Hit from, double u, double v, Arrival out) {
            out.towards(from, position.x(), position.y(), position.z());
            out.light(1, 1, 1);
            return u >= 0 && u < 1 && v >= 0 && v < 1;
        }
    }

    @Test
    void aLightMadeInCodeLooksAsOursOfTheSameForm() {
        Scene scene = around(new Block(new Vec3(-0.6, -0.6, -0.6), new Vec3(0.6, 0.6, 0.6)));
        Vec3 position = new Vec3(3, 6, 9);
        int[] ours = Renderer.render(scene).toArgb();
        assertThat(Renderer.render(scene.withLights(List.of(new Bulb(position, 1)))).toArgb()).isEqualTo(ours);
        assertThat(Renderer.render(scene.withLights(List.of(new Bulb(position, 16)))).toArgb()).as("the mean of what is the same").isEqualTo(ours);
        assertThatThrownBy(() -> RenderScene.of(scene.withLights(List.of(new Bulb(position, 0))))).isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("samples of a bulb must be");
    }

    /** Answers that are no numbers, from whatever asks first. */
    static Stream<Arguments> brokenScenes() {
        return Stream.of(
                arguments("the light \"burnt\", which is made in code, sends NaN 1.0 1.0 from the direction", lit(out -> out.light(Double.NaN, 1, 1))),
                arguments("the light \"burnt\", which is made in code, sends 1.0 1.0 Infinity", lit(out -> out.light(1, 1, Double.POSITIVE_INFINITY))),
                arguments("light must be finite, a direction of length 1", lit(out -> out.along(0, 2, 0))),
                arguments("light must be finite, a direction of length 1", lit(out -> out.distance = Double.NaN)),
                arguments("the pattern \"smudge\", which is made in code, has the colour 0.5 NaN 0.5 at ", patterned(new Smudge(Double.NaN))),
                arguments("the pattern \"smudge\", which is made in code, has the colour 0.5 -Infinity 0.5 at ", patterned(new Smudge(Double.NEGATIVE_INFINITY))),
                arguments("a veil has a normal that is no direction, of its face 0 at ", Scenes.empty().plus(SceneObject.of(new Veil(0, 0, 1)))),
                arguments("a veil says that a line crosses it at NaN", Scenes.empty().plus(SceneObject.of(new Veil(1, Double.NaN, 1)))),
                arguments("a veil has a u of NaN and a v of 0.0, which are no numbers, on its face 0 at ",
                        Scenes.empty().plus(SceneObject.of(new Veil(1, 0, 1)).madeOf(Material.DEFAULT.withPattern(new ByPlace())))));
    }

    @ParameterizedTest
    @MethodSource("brokenScenes")
    void whatIsNoNumberIsToldOnceAndByName(String sentence, Scene scene) {
        assertThatThrownBy(() -> Renderer.render(scene)).isInstanceOf(IllegalStateException.class).message().contains(sentence).doesNotContain("Exception").hasLineCount(1);
    }

    @Test
    void aShapeWithoutBoundsInNumbersIsRefusedBeforeItIsRendered() {
        assertThatThrownBy(() -> RenderScene.of(Scenes.empty().plus(SceneObject.of(new Veil(1, 0, Double.NaN))))).isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("the bounds of a veil must be of numbers, but are ");
    }

    /** Of face −1, or without end. */
    @Test
    void crossingsThatCannotBeAreToldRatherThanTakenForOthers() {
        assertThatThrownBy(() -> Renderer.render(Scenes.empty().plus(SceneObject.of(new Anything(line -> line.cross(1, -1))))))
                .hasMessageContaining("the faces of a shape have numbers from 0 on, and one that a line crosses has -1");
        assertThatThrownBy(() -> Renderer.render(Scenes.empty().plus(SceneObject.of(new Anything(line -> {
            while (true) {
                line.cross(1);
            }
        }))))).hasMessageContaining("more than 1048576 times");
    }

    @Test
    void whatHasNoNameIsCalledByWhatItIsOne() {
        CustomPattern bright = (x, y, z, hit) -> hit.color(1, 1, 1);
        assertThat(bright.kind()).isEqualTo("custom-pattern");
        assertThat(new Smudge(1).kind()).isEqualTo("smudge");
    }

    private record Anything(Consumer<Line> crossing) implements CustomShape {
        @Override
        public Bounds bounds() {
            return Bounds.around(Vec3.ZERO, Vec3.ONE);
        }

        @Override
        public void cross(Line line) {
            crossing.accept(line);
        }

        @Override
        public void normal(int face, Hit hit) {
            hit.normal(0, 0, 1);
        }
    }

    private static Scene lit(Consumer<Arrival> broken) {
        return around(new Block(new Vec3(-0.6, -0.6, -0.6), new Vec3(0.6, 0.6, 0.6))).withLights(List.of(new Burnt(broken)));
    }

    private record Burnt(Consumer<Arrival> broken) implements CustomLight {
        @Override
        public boolean sample(Hit from, double u, double v, Arrival out) {
            out.towards(from, 3, 6, 9);
            out.light(1, 1, 1);
            broken.accept(out);
            return true;
        }
    }

    private record Smudge(double green) implements CustomPattern {
        @Override
        public void color(double x, double y, double z, Hit hit) {
            hit.color(0.5, green, 0.5);
        }
    }

    /** The plane z = 0, with a normal of some length, crossed a little aside. */
    private record Veil(double length, double aside, double edge) implements CustomShape {
        @Override
        public Bounds bounds() {
            return new Bounds(-edge, -edge, -edge, edge, edge, edge);
        }

        @Override
        public void cross(Line line) {
            line.cross(-line.oz / line.dz + aside);
        }

        @Override
        public void normal(int face, Hit hit) {
            hit.normal(0, 0, length);
        }

        @Override
        public void map(int face, Hit hit) {
            hit.map(Double.NaN, 0, 1, 0, 0);
        }
    }

    @Test
    void fixedPointsAreThoseOfOurOwnLights() {
        for (int samples : new int[] {1, 4}) {
            assertThat(FixedPoints.of(new Bulb(new Vec3(3, 6, 9), samples), 0)).isEmpty();
        }
        assertThat(FixedPoints.of(new SunLight("", new Vec3(0, -1, 0), Rgb.WHITE, 1, 0.5, false), 0)).isNotEmpty();
    }

    @Test
    void explanationsAndTablesCallThemAsTheyCallThemselves() throws Exception {
        Scene scene = around(new Crate(0.6)).plus(new Bulb(new Vec3(-3, 6, 9), 4));
        var pixel = RenderScene.of(scene).explain(scene.settings().width() / 2 - 3, scene.settings().height() / 2);
        assertThat(String.join("\n", TreeText.lines(pixel, 0.01, Decoration.NONE))).contains("hits           crate #1, from outside");
        assertThat(Filter.parse("exists(light where kind = \"bulb\")", SceneTables.SCENE).test(scene)).isTrue();
        assertThat(Filter.parse("exists(object where kind = \"crate\")", SceneTables.SCENE).test(scene)).isTrue();
    }

    @Test
    void filesRefuseThemWithASentence(@TempDir Path folder) throws Exception {
        Scene shape = around(new Crate(0.6));
        Scene pattern = patterned(new Cubes(1));
        Scene light = Scene.EMPTY.plus(new Bulb(Vec3.ZERO, 1));
        String aboutLight = "cannot hold the light \"bulb\", which is made in code";
        String aboutShape = "cannot hold the shape \"crate\", which is made in code";
        String aboutPattern = "cannot hold the pattern \"cubes\", which is made in code";
        Path file = folder.resolve("scene.xml");
        assertThatThrownBy(() -> SceneFiles.write(shape, file)).isInstanceOf(IllegalArgumentException.class).hasMessage("a scene file " + aboutShape);
        assertThatThrownBy(() -> SceneFiles.write(pattern, file)).isInstanceOf(IllegalArgumentException.class).hasMessage("a scene file " + aboutPattern);
        assertThatThrownBy(() -> SceneFiles.writeAll(List.of(shape.withName("a")), file)).hasMessage("a scene file " + aboutShape);
        assertThatThrownBy(() -> PovFiles.write(shape, file)).isInstanceOf(IllegalArgumentException.class).hasMessage("a scene for POV-Ray " + aboutShape);
        assertThatThrownBy(() -> PovFiles.write(pattern, file)).hasMessage("a scene for POV-Ray " + aboutPattern);
        assertThatThrownBy(() -> SceneFiles.write(light, file)).isInstanceOf(IllegalArgumentException.class).hasMessage("a scene file " + aboutLight);
        assertThatThrownBy(() -> PovFiles.write(light, file)).isInstanceOf(IllegalArgumentException.class).hasMessage("a scene for POV-Ray " + aboutLight);
        assertThat(file).doesNotExist();
        SceneFiles.write(Scene.EMPTY, file);
        byte[] before = Files.readAllBytes(file);
        SceneFile open = SceneFiles.open(file);
        assertThatThrownBy(() -> open.save(shape)).hasMessage("a scene file " + aboutShape);
        assertThat(file).hasBinaryContent(before);
    }
}
