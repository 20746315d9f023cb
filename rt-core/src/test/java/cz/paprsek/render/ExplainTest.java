package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.ShippedPictures;
import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.LightTerm;
import cz.paprsek.render.explain.LightTerm.ShadowRay;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

class ExplainTest {
    /** In every build a ninth of the pixels that the proof, to be had by {@code -Dpaprsek.proof}, looks at. */
    private static final int WIDTH = System.getProperty("paprsek.proof") == null ? 32 : 96;

    static Stream<Scene> scenes() throws Exception {
        try (Stream<Path> files = Files.list(Path.of("../scenes"))) {
            Stream.Builder<Scene> scenes = Stream.builder();
            for (Path file : files.filter(name -> name.toString().endsWith(".xml")).sorted().toList()) {
                SceneFiles.readAll(file).forEach(scene -> scenes.add(scene.withSettings(
                        new RenderSettings(WIDTH, WIDTH * 9 / 16, scene.settings().maxDepth(), 1))));
            }
            return scenes.build();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everyTreeOfEverySceneAddsUpToThePixelBitForBit(Scene scene) {
        assertEveryPixelAddsUp(scene);
    }

    /** A quarter of a turn leaves the faces along the axes of the world: they keep the names they have on the block. */
    @ParameterizedTest
    @CsvSource({"0, PLUS_Z", "90, MINUS_X", "180, MINUS_Z", "270, PLUS_X", "30, PLUS_Z", "100, MINUS_X"})
    void aFaceIsCalledByTheBlocksOwnAxes(double turn, Shape.Face face) {
        Scene scene = Scenes.empty().plus(SceneObject.of(new Block(new Vec3(-1, -1, -1), new Vec3(1, 1, 1))).rotated(0, turn, 0));
        var pixel = RenderScene.of(scene).explain(scene.settings().width() / 2, scene.settings().height() / 2);
        assertThat(pixel.rays().get(0).encounter().orElseThrow().place().face()).isEqualTo(face);
    }

    @Test
    void everyTreeOfRandomBodiesAddsUpToThePixelBitForBit() {
        for (int seed = 0; seed < 20; seed++) {
            assertEveryPixelAddsUp(Scenes.random(seed, 12));
        }
    }

    @Test
    void soDoesItThroughAnyLensInAnyLightWithAnySamples() {
        for (int seed = 0; seed < 20; seed++) {
            assertEveryPixelAddsUp(Scenes.randomlySeen(seed, 8));
        }
    }

    @Test
    void severalSamplesAreSeveralTreesOnePixel() throws IOException {
        Scene scene = Scenes.random(7, 12);
        scene = scene.withSettings(scene.settings().withSamples(3));
        assertThat(RenderScene.of(scene).explain(16, 12).rays()).hasSize(9);
        assertEveryPixelAddsUp(scene);
    }

    @ParameterizedTest
    @EnumSource(PixelFilter.class)
    void soAreAsManyAsAPixelTakesWhateverTheirWeights(PixelFilter filter) {
        Scene scene = Scenes.random(7, 12);
        scene = scene.withSettings(scene.settings().withSamples(2, 5).withFilter(filter));
        RenderScene prepared = RenderScene.of(scene);
        RenderSettings settings = scene.settings();
        Set<Integer> counts = IntStream.range(0, 25).mapToObj(y -> prepared.explain(settings, 16, y).rays().size()).collect(Collectors.toSet());
        assertThat(counts).contains(4).hasSizeGreaterThan(1).isSubsetOf(4, 8, 16, 25);
        assertEveryPixelAddsUp(scene);
        assertEveryPixelAddsUp(scene.withSettings(settings.withSamples(3)));
    }

    private static void assertEveryPixelAddsUp(Scene scene) {
        RenderScene prepared = ShippedPictures.ready(scene);
        Image image = Renderer.render(prepared, RenderOptions.of(scene), RenderMonitor.NONE).image();
        for (int row = 0; row < image.height(); row++) {
            for (int column = 0; column < image.width(); column++) {
                Pixel pixel = prepared.explain(column, row);
                LinearRgb light = pixel.light();
                assertThat(new float[] {(float) light.red(), (float) light.green(), (float) light.blue()})
                        .as("pixel %d,%d of %s", column, row, scene.name())
                        .isEqualTo(new float[] {image.red(column, row), image.green(column, row), image.blue(column, row)});
                pixel.rays().forEach(ray -> assertAddsUp(ray, 1));
            }
        }
    }

    private static void assertAddsUp(TracedRay ray, int level) {
        assertThat(ray.level()).isEqualTo(level);
        assertThat(ray.direction().length()).isCloseTo(1, Offset.offset(1e-9));
        ray.encounter().ifPresent(met -> {
            LinearRgb sum = met.terms().stream().reduce(LinearRgb::plus).orElseThrow();
            assertThat(ray.absorbed().map(by -> by.left().times(sum)).orElse(sum)).isEqualTo(ray.light());
            met.lights().forEach(term -> assertIsConsistent(met, term));
        });
        ray.children().forEach(child -> assertAddsUp(child, level + 1));
    }

    private static void assertIsConsistent(Encounter met, LightTerm term) {
        LinearRgb sum = LinearRgb.BLACK;
        for (ShadowRay ray : term.rays()) {
            double through = ray.obstacles().stream().mapToDouble(ShadowRay.Obstacle::transparency).reduce(1, (a, b) -> a * b);
            assertThat(ray.isSent() ? through : 0).as("%s", ray).isCloseTo(ray.visibility(), Offset.offset(1e-12));
            double shown = met.place().towardsViewer().dot(ray.direction());
            double itself = (met.place().fromInside() ? met.place().normal().negated() : met.place().normal()).dot(ray.direction());
            // Where the normal for light and that of the surface do not agree on the side, it is not lit.
            assertThat(ray.facing()).as("%s", ray).isEqualTo(ray.facing() == 0 && (shown > 0) != (itself > 0) ? 0 : shown);
            sum = sum.plus(ray.added());
        }
        assertThat(term.rays().size() == 1 ? sum : sum.times(1.0 / term.rays().size())).as("%s", term).isEqualTo(term.added());
    }

    @Test
    void aPointBetweenPixelCentresHasATreeOfItsOwn() {
        Scene scene = Scenes.random(3, 12);
        RenderScene prepared = RenderScene.of(scene);
        RenderSettings settings = scene.settings();
        assertThat(prepared.explainPoint(settings, 10.5, 12.5)).isEqualTo(prepared.explain(10, 12).rays().get(0));
        assertThat(prepared.explainPoint(settings, 10.25, 12.75))
                .isEqualTo(prepared.explain(settings.withSamples(2), 10, 12).rays().get(2));
    }

    @Test
    void anyRayHasATree() {
        Scene scene = Scenes.random(3, 12);
        RenderScene prepared = RenderScene.of(scene);
        TracedRay seen = prepared.explain(16, 12).rays().get(0);
        TracedRay alone = prepared.explainRay(seen.origin(), new Vec3(0, 0, -7), scene.settings().maxDepth());
        assertThat(alone).isEqualTo(seen);
    }

    @Test
    void aPixelOutsideThePictureIsRefused() {
        RenderScene prepared = RenderScene.of(Scenes.empty());
        assertThatThrownBy(() -> prepared.explain(33, 0)).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("pixel 33,0 must lie inside the picture of 33 × 25 pixels");
    }

    @Test
    void moreRaysThanAnybodyReadsAreRefused_andWhoWaitsCanGiveUp() {
        Material half = Material.DEFAULT.withTransparency(0.5, 1.2).withReflection(0.5);
        Scene scene = Scenes.empty().plus(SceneObject.of(new Sphere(1)).madeOf(half), SceneObject.of(new Sphere(9)).madeOf(half));
        RenderScene prepared = RenderScene.of(scene);
        RenderSettings deep = scene.settings().withMaxDepth(60);
        assertThatThrownBy(() -> prepared.explain(deep, 16, 12)).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("there are more than 100000 rays, too many to explain; ask for a lower max-depth or fewer samples");
        assertThatThrownBy(() -> prepared.explainRay(new Vec3(0, 0, 5), new Vec3(0, 0, -1), 60)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> prepared.explain(RenderOptions.of(deep), 16, 12, new RenderMonitor() {
            private int asked;

            @Override
            public boolean cancelled() {
                return ++asked > 100;
            }
        })).isInstanceOf(CancellationException.class);
        Thread.currentThread().interrupt();
        try {
            assertThatThrownBy(() -> prepared.explain(deep, 16, 12)).isInstanceOf(CancellationException.class);
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
        assertThat(prepared.explain(16, 12).rays()).hasSize(1);
    }
}
