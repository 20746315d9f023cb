package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.drawing.Legend;
import cz.paprsek.image.Image;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.render.mode.RenderMode.HeatScale;
import cz.paprsek.render.show.ObjectColors;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class RenderModeTest {
    private static final int MIDDLE_X = 16;
    private static final int MIDDLE_Y = 12;

    /** A ball of radius 1 at the origin in the middle, a screen behind it; 33 × 25 pixels from z = 5. */
    private static Scene ball() {
        return Scenes.empty().plus(Light.at(0, 0, 9))
                .plus(SceneObject.of(new Sphere(1)), SceneObject.of(new Block(new Vec3(-9, -9, -3), new Vec3(9, 9, -2))));
    }

    private static Image render(Scene scene, RenderMode mode) {
        return Renderer.render(RenderScene.of(scene), RenderOptions.of(scene).withMode(mode), RenderMonitor.NONE).image();
    }

    private static int middle(Image image) {
        return image.argb(MIDDLE_X, MIDDLE_Y) & 0xFFFFFF;
    }

    @Test
    void normalsAreColoursByAxis() {
        assertThat(middle(render(ball(), RenderMode.NORMALS))).isEqualTo(0x8080FF);
        assertThat(middle(render(Scenes.empty(), RenderMode.NORMALS))).as("nothing").isZero();
        Image image = render(ball(), RenderMode.NORMALS);
        assertThat(image.red(MIDDLE_X + 4, MIDDLE_Y)).isGreaterThan(image.red(MIDDLE_X - 4, MIDDLE_Y));
        assertThat(image.green(MIDDLE_X, MIDDLE_Y - 4)).isGreaterThan(image.green(MIDDLE_X, MIDDLE_Y + 4));
    }

    @Test
    void whatIsNearerIsLighter() {
        Image image = render(ball(), RenderMode.DEPTH);
        assertThat(image.argb(MIDDLE_X, MIDDLE_Y) & 0xFF).isGreaterThan(250);
        assertThat(image.red(MIDDLE_X + 4, MIDDLE_Y)).isLessThan(image.red(MIDDLE_X, MIDDLE_Y));
        assertThat(image.red(0, 0)).isLessThan(image.red(MIDDLE_X + 4, MIDDLE_Y)).isPositive();
    }

    /** A floor that ends at the horizon is some 100 times as far away there as the ball, in whose middle it would be nearly white. */
    @Test
    void aHorizonLeavesWhatIsBeforeItApart() throws SceneFileException {
        Scene floor = SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><render width='33' height='25'/><camera position='0 1 5' target='0 1 0'/>"
                + "<plane/><sphere radius='1' position='0 1 0'/></scene>");
        Image image = render(floor, RenderMode.DEPTH);
        int ball = image.argb(MIDDLE_X, MIDDLE_Y) & 0xFF;
        assertThat(image.argb(MIDDLE_X, 24) & 0xFF).as("in front of it").isGreaterThan(ball + 25);
        assertThat(image.argb(0, MIDDLE_Y + 1) & 0xFF).as("behind it").isLessThan(ball - 25).isPositive();
    }

    @Test
    void everyObjectHasAColourOfItsOwn() {
        Image image = render(ball(), RenderMode.OBJECTS);
        assertThat(image.argb(MIDDLE_X, MIDDLE_Y)).isEqualTo(image.argb(MIDDLE_X + 3, MIDDLE_Y)).isNotEqualTo(image.argb(0, 0));
        assertThat(IntStream.range(0, 1000).mapToObj(ObjectColors::of).distinct()).hasSize(1000);
    }

    @Test
    void raysAreCountedByPixel() {
        assertThat(middle(render(Scenes.empty(), RenderMode.RAYS))).as("one from the eye").isEqualTo(encoded(HeatScale.RAYS.color(1)));
        assertThat(middle(render(ball(), RenderMode.RAYS))).as("one from the eye, one to the light").isEqualTo(encoded(HeatScale.RAYS.color(2)));
        Scene finer = ball();
        finer = finer.withSettings(finer.settings().withSamples(3));
        assertThat(middle(render(finer, RenderMode.RAYS))).as("nine of each").isEqualTo(encoded(HeatScale.RAYS.color(18)));
    }

    private static Image numbers(Scene scene, RenderMode mode) {
        return Renderer.render(RenderScene.of(scene), RenderOptions.of(scene).withMode(mode).withNumbers(), RenderMonitor.NONE).image();
    }

    @Test
    void programsGetDistancesAndCountsAsTheyAre() {
        assertThat(numbers(ball(), RenderMode.DEPTH).red(MIDDLE_X, MIDDLE_Y)).as("from z = 5 to z = 1").isEqualTo(4);
        assertThat(numbers(Scenes.empty(), RenderMode.DEPTH).red(MIDDLE_X, MIDDLE_Y)).as("nothing").isZero();
        Scene finer = ball();
        finer = finer.withSettings(finer.settings().withSamples(3));
        assertThat(numbers(finer, RenderMode.RAYS).green(MIDDLE_X, MIDDLE_Y)).as("nine to the ball, nine to the light").isEqualTo(18);
        assertThat(numbers(finer, RenderMode.DEPTH).blue(MIDDLE_X, MIDDLE_Y)).as("the mean of nine").isBetween(4f, 4.05f);
        assertThat(numbers(ball(), RenderMode.NODES).red(MIDDLE_X, MIDDLE_Y)).isGreaterThanOrEqualTo(1);
        Image light = render(ball(), RenderMode.SHADED);
        assertThat(numbers(ball(), RenderMode.SHADED).toArgb()).as("light is light").isEqualTo(light.toArgb());
    }

    @Test
    void manyBodiesTakeMoreNodes() {
        Image few = render(ball(), RenderMode.NODES);
        Image many = render(Scenes.random(5, 200), RenderMode.NODES);
        assertThat(many.red(MIDDLE_X, MIDDLE_Y)).isGreaterThan(few.red(MIDDLE_X, MIDDLE_Y));
    }

    @Test
    void shadowsShowWhichLightsArrive() {
        Scene two = ball().withLights(List.of(
                Light.at(3, 0, 9).withColor(new Rgb(255, 0, 0)), Light.at(0, 0, -9).withColor(new Rgb(0, 0, 255))));
        assertThat(middle(render(two, RenderMode.SHADOWS))).as("the red one before it, not the blue one behind").isEqualTo(0xFF0000);
        assertThat(render(two, RenderMode.SHADOWS).red(MIDDLE_X - 7, MIDDLE_Y)).as("in the shadow of the ball").isEqualTo(0);
    }

    @Test
    void samplesSayHowManyRaysFromTheEyeAPixelTook() {
        Scene random = Scenes.random(11, 30);
        Scene scene = random.withSettings(random.settings().withSamples(2, 4));
        Image counts = numbers(scene, RenderMode.SAMPLES);
        long sum = 0;
        for (int y = 0; y < counts.height(); y++) {
            for (int x = 0; x < counts.width(); x++) {
                assertThat(counts.red(x, y)).isIn(4f, 8f, 16f);
                sum += (long) counts.red(x, y);
            }
        }
        assertThat(sum).isEqualTo(Renderer.render(RenderScene.of(scene), RenderOptions.of(scene), RenderMonitor.NONE).stats().primary());
        assertThat(numbers(random, RenderMode.SAMPLES).red(3, 3)).isEqualTo(1);
    }

    @ParameterizedTest
    @EnumSource(RenderMode.class)
    void everyModeGivesTheSameBytesForAnyThreadsAndRegion(RenderMode mode) {
        Scene random = Scenes.random(11, 30);
        Scene scene = mode == RenderMode.SAMPLES || mode == RenderMode.ERROR ? random.withSettings(random.settings().withSamples(2, 8)) : random;
        RenderScene prepared = RenderScene.of(scene);
        RenderOptions options = RenderOptions.of(scene).withMode(mode);
        Image one = Renderer.render(prepared, options.withThreads(1), RenderMonitor.NONE).image();
        Image four = Renderer.render(prepared, options.withThreads(4), RenderMonitor.NONE).image();
        assertThat(four.toArgb()).isEqualTo(one.toArgb());
        Image part = Renderer.render(prepared, options.withRegion(new Tile(7, 5, 9, 8)), RenderMonitor.NONE).image();
        assertThat(part.argb(3, 2)).isEqualTo(one.argb(10, 7));
        assertThat(IntStream.of(one.toArgb()).distinct().count()).as("something to see").isGreaterThan(2);
    }

    @Test
    void aLegendStandsBelowThePicture() {
        Image picture = render(ball(), RenderMode.RAYS);
        Image longer = Legend.below(picture, HeatScale.RAYS);
        assertThat(longer.height()).isEqualTo(picture.height() + Legend.HEIGHT);
        assertThat(longer.argb(5, 5)).isEqualTo(picture.argb(5, 5));
        assertThat(IntStream.range(0, 33).map(x -> longer.argb(x, picture.height() + 5)).distinct().count()).isGreaterThan(5);
    }

    private static int encoded(Rgb color) {
        return (int) Math.round(color.red()) << 16 | (int) Math.round(color.green()) << 8 | (int) Math.round(color.blue());
    }
}
