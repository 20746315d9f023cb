package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Pattern.Filter;
import cz.paprsek.material.Pattern.Lay;
import cz.paprsek.material.Pattern.Mapping;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Pictures on surfaces and in the sky, against what is in them, and means that can be worked out. POV-Ray's own are compared in the cross-check. */
class PictureTest {
    /** Four by two points: red = column / 4, green = row from the top / 2. */
    private static final byte[] FOUR_BY_TWO = png(4, 2, (x, y) -> new double[] {x / 4.0, y / 2.0, 0});

    private interface Points {
        double[] at(int x, int y);
    }

    private static Image image(int width, int height, Points points) {
        Image image = new Image(width, height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                double[] rgb = points.at(x, y);
                image.set(x, y, rgb[0], rgb[1], rgb[2]);
            }
        }
        return image;
    }

    private static byte[] png(int width, int height, Points points) {
        return written(image(width, height, points), ImageFormat.PNG);
    }

    private static byte[] written(Image image, ImageFormat format) {
        try {
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            ImageFiles.write(image, out, format);
            return out.toByteArray();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Scene lit(Pattern pattern) {
        return Scenes.empty().withAmbient(Rgb.WHITE).plus(SceneObject.of(new Rectangle(0, 0, 1, 1)).madeOf(Material.DEFAULT.withDiffusion(0).withPattern(pattern)));
    }

    private static double[] seen(Scene scene, byte[] picture, double x, double y) {
        Scene from = scene.withSettings(new RenderSettings(3, 3, 5, 1)).withCamera(Camera.looking(new Vec3(x, y, 5), new Vec3(0, 0, -1)).withLens(new Lens.Orthographic(1e-6)));
        Image image = Renderer.render(RenderScene.of(from, Assets.of(Map.of("p", picture)), RenderMonitor.NONE), RenderOptions.of(from), RenderMonitor.NONE).image();
        return new double[] {image.red(1, 1), image.green(1, 1), image.blue(1, 1)};
    }

    private static Pattern on(Filter filter, Mapping mapping, Lay lay) {
        return new Pattern.Picture("p", filter, mapping, lay);
    }

    @ParameterizedTest
    @CsvSource({"0.01, 0.99, 0, 0", "0.26, 0.99, 0.25, 0", "0.99, 0.51, 0.75, 0", "0.99, 0.49, 0.75, 0.5", "0.1, 0.01, 0, 0.5"})
    void theNearestPointIsSeenWithVUp(double x, double y, double red, double green) {
        assertThat(seen(lit(on(Filter.NEAREST, Mapping.UV, Lay.NONE)), FOUR_BY_TWO, x, y)).containsExactly(new double[] {red, green, 0}, within(0.005));
    }

    /** Points lie in the middles of their squares, and beyond the last comes the first. */
    @ParameterizedTest
    @CsvSource({"0.125, 0.75, 0, 0", "0.25, 0.75, 0.125, 0", "0.3125, 0.75, 0.1875, 0", "0.125, 0.5, 0, 0.25", "0.125, 0.375, 0, 0.375", "0.9999999, 0.75, 0.375, 0"})
    void fourPointsAreMixedLinearlyInLight(double x, double y, double red, double green) {
        for (Filter filter : new Filter[] {Filter.BILINEAR, Filter.SMOOTH}) {
            assertThat(seen(lit(on(filter, Mapping.UV, Lay.NONE)), FOUR_BY_TWO, x, y)).as("%s", filter).containsExactly(new double[] {red, green, 0}, within(0.005));
        }
    }

    @Test
    void aPictureIsMovedTurnedAndScaledOnItsSurface() {
        // A quarter of the size, from (0.5, 0.5), upwards instead of to the right.
        Pattern quarter = on(Filter.NEAREST, Mapping.UV, new Lay(new Vec3(0.5, 0.5, 0), new Vec3(0, 0, 90), new Vec3(0.25, 0.25, 1)));
        assertThat(seen(lit(quarter), FOUR_BY_TWO, 0.5 - 0.24, 0.5 + 0.07)).containsExactly(new double[] {0.25, 0, 0}, within(0.005));
        assertThat(seen(lit(on(Filter.NEAREST, Mapping.PLANAR, Lay.scaled(0.5))), FOUR_BY_TWO, 0.9, 0.3)).containsExactly(new double[] {0.75, 0, 0}, within(0.005));
    }

    @ParameterizedTest
    @EnumSource(value = ImageFormat.class, names = {"PNG", "HDR", "EXR", "PPM"})
    void everyKindOfPictureIsSeen(ImageFormat format) {
        byte[] file = written(image(4, 2, (x, y) -> new double[] {x / 4.0, y / 2.0, 1}), format);
        assertThat(seen(lit(on(Filter.NEAREST, Mapping.UV, Lay.NONE)), file, 0.6, 0.2)).containsExactly(new double[] {0.5, 0.5, 1}, within(0.008));
    }

    /** A checkered floor to the horizon: at a distance a pixel covers many squares, and shows their mean, by itself and in a mirror. */
    @Test
    void whatIsSeenFromAfarIsTheMean() {
        byte[] squares = png(64, 64, (x, y) -> (x / 32 + y / 32) % 2 == 0 ? new double[] {1, 1, 1} : new double[] {0, 0, 0});
        Scene floor = Scenes.empty().withAmbient(Rgb.WHITE).withBackground(Rgb.BLACK).withSettings(new RenderSettings(96, 64, 5, 1))
                .withCamera(Camera.looking(new Vec3(0, 1, 5), new Vec3(0, 0, -1)))
                .plus(SceneObject.of(new Plane()).madeOf(Material.DEFAULT.withDiffusion(0).withPattern(Pattern.Picture.of("p"))))
                .plus(SceneObject.of(new Sphere(1)).at(0, 1, 0).madeOf(Material.color(Rgb.BLACK).withDiffusion(0).withReflection(1)));
        Image image = Renderer.render(RenderScene.of(floor, Assets.of(Map.of("p", squares)), RenderMonitor.NONE), RenderOptions.of(floor), RenderMonitor.NONE).image();
        // The row below the horizon: grey, within a little, though it is a hundred squares away.
        for (int x = 0; x < 30; x++) {
            assertThat((double) image.red(x, 32)).as("column %d", x).isCloseTo(0.5, within(0.12));
        }
        // In the ball the floor is seen much smaller: just below its middle row all is grey.
        for (int x = 40; x < 56; x++) {
            assertThat((double) image.red(x, 33)).as("in the mirror, column %d", x).isCloseTo(0.5, within(0.15));
        }
        // Nearby there are squares, sharp ones.
        int sharp = 0;
        for (int x = 0; x < 96; x++) {
            sharp += image.red(x, 63) < 0.05 || image.red(x, 63) > 0.95 ? 1 : 0;
        }
        assertThat(sharp).isGreaterThan(60);
    }

    @Test
    void aSkyHasItsColoursByTheHeightOfTheRay() {
        Scene scene = Scenes.empty().withSky(new Sky.Gradient(Rgb.ofLinear(0, 0, 1), Rgb.ofLinear(0.5, 0.5, 0.5), Rgb.ofLinear(1, 0, 0)));
        assertThat(Scenes.middle(scene.withCamera(Camera.looking(Vec3.ZERO, new Vec3(1, 0, 0))))).isCloseTo(0.5, within(1e-6));
        assertThat(sky(scene, new Vec3(0.6, 0.8, 0), Assets.none())).containsExactly(new double[] {0.1, 0.1, 0.9}, within(1e-6));
        assertThat(sky(scene, new Vec3(0, -0.28, 0.96), Assets.none())).containsExactly(new double[] {0.64, 0.36, 0.36}, within(1e-6));
    }

    /** Points of the sky's picture, in the direction of their middles: u = atan2(z, x)/2π, and v = ½ + asin(y)/π. */
    @ParameterizedTest
    @CsvSource({"0, 0", "1, 0", "3, 1", "2, 1"})
    void aPictureOfTheSkyIsSeenInItsDirection(int column, int row) {
        double u = (column + 0.5) / 4 * 2 * Math.PI;
        double v = (0.5 - (row + 0.5) / 2) * Math.PI;
        Vec3 direction = new Vec3(Math.cos(u) * Math.cos(v), Math.sin(v), Math.sin(u) * Math.cos(v));
        Scene scene = Scenes.empty().withSky(new Sky.Picture("p", 0, 2));
        assertThat(sky(scene, direction, Assets.of(Map.of("p", FOUR_BY_TWO)))).containsExactly(new double[] {column / 2.0, row, 0}, within(0.01));
        // Turned counter-clockwise by a quarter, seen from above, what was at x is now at −z.
        Scene turned = scene.withSky(new Sky.Picture("p", 90, 2));
        assertThat(sky(turned, new Vec3(direction.z(), direction.y(), -direction.x()), Assets.of(Map.of("p", FOUR_BY_TWO)))).containsExactly(new double[] {column / 2.0, row, 0}, within(0.01));
    }

    /** Squares far finer than pixels are one grey: straight from the eye, and in a ball that mirrors them finer still. */
    @Test
    void aFineSkyIsEvenFromAfarAndInAMirror() {
        byte[] squares = png(512, 256, (x, y) -> (x + y) % 2 == 0 ? new double[] {1, 1, 1} : new double[] {0, 0, 0});
        Scene scene = Scenes.empty().withSettings(new RenderSettings(24, 18, 3, 1)).withSky(new Sky.Picture("p", 0, 1))
                .plus(SceneObject.of(new Sphere(1.2)).madeOf(Material.DEFAULT.withDiffusion(0).withReflection(1)));
        Scene from = scene.withCamera(Camera.looking(new Vec3(0, 0, 5), new Vec3(0, 0, -1)).withLens(Lens.Perspective.DEFAULT.withFovy(100)));
        Image image = Renderer.render(RenderScene.of(from, Assets.of(Map.of("p", squares)), RenderMonitor.NONE), RenderOptions.of(from), RenderMonitor.NONE).image();
        for (int i = 0; i < 24 * 18; i++) {
            assertThat(image.red(i % 24, i / 24)).isCloseTo(0.5f, within(0.05f));
        }
    }

    private static double[] sky(Scene scene, Vec3 direction, Assets assets) {
        var light = RenderScene.of(scene, assets, RenderMonitor.NONE).explainRay(Vec3.ZERO, direction, 3).light();
        return new double[] {light.red(), light.green(), light.blue()};
    }

    @Test
    void aPictureThatIsMissingOrNoPictureIsRefusedByName() {
        Scene scene = lit(Pattern.Picture.of("p"));
        assertThatThrownBy(() -> RenderScene.of(scene)).isInstanceOf(UncheckedIOException.class).hasMessage("\"p\": there are no files beside this scene");
        byte[] text = "no picture".getBytes(StandardCharsets.US_ASCII);
        assertThatThrownBy(() -> RenderScene.of(scene, Assets.of(Map.of("p", text)), RenderMonitor.NONE)).isInstanceOf(UncheckedIOException.class)
                .hasMessage("\"p\": this is not a picture of a kind that can be read");
    }

    @Test
    void aSceneKnowsItsFiles() {
        Scene scene = lit(Pattern.Picture.of("b.png")).withSky(new Sky.Picture("a.hdr", 0, 1)).plus("oak", Material.DEFAULT.withPattern(Pattern.Picture.of("c/d.jpg")));
        assertThat(scene.files()).containsExactly("a.hdr", "b.png", "c/d.jpg");
    }

    /** Eight bits a channel take three bytes a point, and the smaller sizes a third more. */
    @Test
    void aPictureOfEightBitsIsKeptAsSuch() throws IOException {
        Image image = Assets.of(Map.of("p", FOUR_BY_TWO)).picture("p").image();
        assertThat(image.isEightBit()).isTrue();
        assertThat(image.red(1, 0)).isEqualTo((float) Rgb.linear(137));
    }
}
