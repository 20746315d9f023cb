package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Bump;
import cz.paprsek.material.Material.NormalMap;
import cz.paprsek.material.Material.Relief;
import cz.paprsek.material.Material.Shares;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Pattern.Colors;
import cz.paprsek.material.Pattern.Lay;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share;
import cz.paprsek.material.Share.ByPattern;
import cz.paprsek.material.Share.ColorChannel;
import cz.paprsek.material.Share.Even;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.text.Decoration;
import cz.paprsek.render.explain.text.TreeJson;
import cz.paprsek.render.explain.text.TreeText;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.words.Words;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Bumps, normal maps and shares by pattern, against closed forms and the same picture in another way. */
class ReliefTest {
    private static final Pattern BLACK_TO_WHITE = new Pattern.Gradient(new Pattern.TwoColors(Rgb.BLACK, Rgb.WHITE), new Lay(new Vec3(0, -1, 0), Vec3.ZERO, new Vec3(2, 2, 2)));

    /** What a point of a white surface, seen and lit from +z, shows of the light: N·L, its kD being 1. */
    private static double facing(Relief relief, Shape shape, Vec3 scale, Map<String, byte[]> pictures) {
        return seen(Scenes.empty().plus(SunLight.along(0, 0, -1)).plus(SceneObject.of(shape).scaled(scale.x(), scale.y(), scale.z())
                .madeOf(Material.DEFAULT.withDiffusion(1).withRelief(relief))), 0.03, 0.02, pictures);
    }

    private static double seen(Scene scene, double x, double y, Map<String, byte[]> pictures) {
        Scene from = scene.withSettings(new RenderSettings(3, 3, 5, 1)).withCamera(Camera.looking(new Vec3(x, y, 9), new Vec3(0, 0, -1)).withLens(new Lens.Orthographic(1e-6)));
        return Renderer.render(RenderScene.of(from, Assets.of(pictures), RenderMonitor.NONE), RenderOptions.of(from), RenderMonitor.NONE).image().red(1, 1);
    }

    private static Image picture(Scene scene) {
        return Renderer.render(scene.withSettings(new RenderSettings(80, 60, 5, 1)));
    }

    /** The height grows by 1 in 2 units of the object, N becomes (0, −s/2, 1); in an object that is drawn out, normals go by the inverse of that. */
    @ParameterizedTest
    @CsvSource({"0.6, 1, 1, 1", "-0.6, 1, 1, 1", "0.6, 3, 3, 3", "3, 0.1, 0.1, 0.1", "0.6, 2, 3, 1", "0.6, 1, 1, 4", "0.6, 2, -2, 2"})
    void aBumpIsAsSteepAsThatWhichItStandsFor(double strength, double x, double y, double z) {
        double slope = strength / 2 / y * z;
        assertThat(facing(new Bump(strength, BLACK_TO_WHITE), new Rectangle(-1, -1, 1, 1), new Vec3(x, y, z), Map.of()))
                .isCloseTo(1 / Math.sqrt(1 + slope * slope), within(1e-6));
    }

    /** On a ball only what of the slope is along it counts. */
    @Test
    void onABallOnlyTheSlopeAlongItCounts() {
        double y = 0.02;
        double x = 0.03;
        double z = Math.sqrt(1 - x * x - y * y);
        Vec3 normal = new Vec3(x, y, z);
        Vec3 slope = Vec3.Y.times(0.5);
        Vec3 bent = normal.minus(slope.minus(normal.times(slope.dot(normal))).times(0.6)).normalized();
        assertThat(facing(new Bump(0.6, BLACK_TO_WHITE), new Sphere(1), Vec3.ONE, Map.of())).isCloseTo(bent.z(), within(1e-6));
    }

    /** From column to column of a picture 2 units wide the height grows by 5/255. */
    @Test
    void aPictureOfASlopeIsASlope() {
        byte[] ramp = png(52, 1, column -> 5 * column);
        double slope = 0.6 * (5 / 255.0) / (2 / 52.0);
        assertThat(facing(new Bump(0.6, Pattern.Picture.of("p")), new Rectangle(-1, -1, 1, 1), Vec3.ONE, Map.of("p", ramp)))
                .isCloseTo(1 / Math.sqrt(1 + slope * slope), within(1e-6));
    }

    /** u to the right, v up: red is x, green y, blue z. On a ball as well, and on what is mirrored, where u grows to the left. */
    @ParameterizedTest
    @CsvSource({"200, 128, 255, 1", "128, 200, 255, 1", "60, 220, 200, 1", "200, 150, 255, 0.5", "60, 220, 200, -1"})
    void aNormalMapSaysTheNormal(int red, int green, int blue, double strength) {
        byte[] one = png(red, green, blue);
        NormalMap map = new NormalMap("p", strength, Pattern.Filter.SMOOTH, Pattern.Mapping.UV, Lay.NONE);
        Vec3 said = new Vec3(strength * (2 * red / 255.0 - 1), strength * (2 * green / 255.0 - 1), 2 * blue / 255.0 - 1).normalized();
        Vec3 towards = new Vec3(0.3, 0.5, 1).normalized();
        for (int mirrored : new int[] {1, -1}) {
            Scene scene = Scenes.empty().plus(SunLight.along(-mirrored * towards.x(), -towards.y(), -towards.z()));
            Material material = Material.DEFAULT.withDiffusion(1).withRelief(map);
            SceneObject flat = SceneObject.of(new Rectangle(-1, -1, 1, 1)).scaled(mirrored, 1, 1).madeOf(material);
            assertThat(seen(scene.plus(flat), 0.2, 0.3, Map.of("p", one))).isCloseTo(Math.max(0, said.dot(towards)), within(1e-6));
            SceneObject ball = SceneObject.of(new Sphere(1)).scaled(mirrored, 1, 1).madeOf(material);
            assertThat(seen(scene.plus(ball), 1e-9, 1e-9, Map.of("p", one))).isCloseTo(Math.max(0, said.dot(towards)), within(1e-6));
        }
    }

    @Test
    void aReliefOfNoHeightIsNone() {
        Scene scene = Scenes.empty().plus(Light.at(3, 4, 5)).withBackground(Rgb.grey(40));
        Material material = Material.DEFAULT.withReflection(0.3);
        SceneObject ball = SceneObject.of(new Sphere(1)).at(0.1, 0.2, -3);
        assertThat(picture(scene.plus(ball.madeOf(material.withRelief(new Bump(0, new Pattern.Noise(3, 0, Colors.DEFAULT, Lay.NONE)))))).toArgb())
                .isEqualTo(picture(scene.plus(ball.madeOf(material))).toArgb());
    }

    /** N is (0, 10, 1) there, which who looks along (0, 0.6, −0.8) sees from behind: edge-on it is (0, 0.8, 0.6). */
    @Test
    void aNormalThatIsSeenFromBehindIsTurnedUntilItIsSeenEdgeOn() {
        Scene scene = obliquely(Material.DEFAULT.withDiffusion(1)).plus(SunLight.along(0, 0, -1));
        assertThat(Renderer.render(scene).red(1, 1)).isCloseTo(0.6f, within(1e-6f));
    }

    /** Mirrored there, the ray would go straight on, to what is red; it is turned back to what is green. */
    @Test
    void aMirroredRayStaysOnTheSideItCameFrom() {
        Scene scene = obliquely(Material.DEFAULT.withDiffusion(0).withReflection(1)).withBackground(new Rgb(0, 255, 0))
                .plus(SceneObject.of(new Rectangle(-9, -9, 9, 9)).at(0, 0, -1).madeOf(Material.color(Rgb.BLACK).withEmission(new Rgb(255, 0, 0), 1)));
        Image image = Renderer.render(scene);
        assertThat(image.red(1, 1)).isZero();
        assertThat(image.green(1, 1)).isEqualTo(1f);
    }

    /** The same on a floor: all is turned by a quarter. */
    @Test
    void aMirroredRayStaysAboveTheFloorItCameFrom() {
        Scene scene = Scenes.empty().withSettings(new RenderSettings(3, 3, 5, 1)).withBackground(new Rgb(0, 255, 0))
                .withCamera(Camera.looking(new Vec3(0, 8, 6), new Vec3(0, -0.8, -0.6)).withLens(new Lens.Orthographic(1e-6)))
                .plus(SceneObject.of(new Rectangle(-1, -1, 1, 1)).rotated(-90, 0, 0).madeOf(Material.DEFAULT.withDiffusion(0).withReflection(1).withRelief(new Bump(-20, BLACK_TO_WHITE))))
                .plus(SceneObject.of(new Rectangle(-9, -9, 9, 9)).at(0, -1, 0).rotated(-90, 0, 0).madeOf(Material.color(Rgb.BLACK).withEmission(new Rgb(255, 0, 0), 1)));
        Image image = Renderer.render(scene);
        assertThat(image.red(1, 1)).isZero();
        assertThat(image.green(1, 1)).isEqualTo(1f);
    }

    private static Scene obliquely(Material material) {
        return Scenes.empty().plus(SceneObject.of(new Rectangle(-1, -1, 1, 1)).madeOf(material.withRelief(new Bump(-20, BLACK_TO_WHITE)))).withSettings(new RenderSettings(3, 3, 5, 1))
                .withCamera(Camera.looking(new Vec3(0, -6, 8), new Vec3(0, 0.6, -0.8)).withLens(new Lens.Orthographic(1e-6)));
    }

    /** ITU-R BT.709, of numbers that are not light. */
    @Test
    void theLuminanceOfAShareIsMostlyItsGreen() {
        assertThat(ColorChannel.LUMINANCE.of(new Rgb(255, 0, 0))).isEqualTo(0.2126);
        assertThat(ColorChannel.LUMINANCE.of(new Rgb(0, 255, 0))).isEqualTo(0.7152);
        assertThat(ColorChannel.LUMINANCE.of(new Rgb(0, 0, 255))).isEqualTo(0.0722);
    }

    /** From behind no light comes through, however the bumps are turned. */
    @ParameterizedTest
    @ValueSource(doubles = {0.02, 0.3, 20})
    void noLightLeaksThroughASheet(double strength) {
        Scene scene = Scenes.empty().plus(Light.at(0.5, 0.7, -3)).plus(Light.at(2, 2, -0.1))
                .plus(SceneObject.of(new Rectangle(-9, -9, 9, 9)).madeOf(Material.DEFAULT.withHighlight(0.5, 3).withRelief(new Bump(strength, new Pattern.Noise(3, 0, Colors.DEFAULT, Lay.NONE)))));
        Image image = picture(scene.withCamera(Camera.lookingAt(new Vec3(0, 0, 4), Vec3.ZERO)));
        for (int i = 0; i < 80 * 60; i++) {
            assertThat(image.red(i % 80, i / 80)).isZero();
        }
    }

    /** A ray that a ball mirrors never meets it again: where all around is white all of it is, and there is no black. */
    @ParameterizedTest
    @ValueSource(doubles = {0.02, 0.3, 20})
    void everyRayThatABumpyBallMirrorsLeavesIt(double strength) {
        Scene scene = Scenes.empty().withBackground(Rgb.WHITE).withCamera(Camera.lookingAt(new Vec3(0, 0, 3), Vec3.ZERO))
                .plus(SceneObject.of(new Sphere(1)).madeOf(Material.DEFAULT.withDiffusion(0).withReflection(1).withRelief(new Bump(strength, new Pattern.Granite(3, 0, Colors.DEFAULT, Lay.NONE)))));
        Image image = picture(scene);
        for (int i = 0; i < 80 * 60; i++) {
            assertThat(image.red(i % 80, i / 80)).isEqualTo(1f);
        }
    }

    /** In each cell the surface is that of a material with this share everywhere, to the last bit. */
    @ParameterizedTest
    @CsvSource({"diffusion, LUMINANCE", "specular, RED", "reflection, GREEN", "transparency, BLUE", "roughness, LUMINANCE"})
    void aShareByAPatternIsThatShareInEachCell(String name, ColorChannel channel) {
        Pattern cells = new Pattern.Stripes(0.5, new Rgb(51, 51, 51), new Rgb(204, 204, 204), Lay.NONE);
        Share by = new ByPattern(channel, cells);
        Material base = Material.DEFAULT.withHighlight(0.2, 20).withReflection(0.4).withTransparency(0.3, 1.3);
        Material varied = base.withShares(new Shares(named(name, "diffusion", by), named(name, "specular", by), named(name, "reflection", by),
                named(name, "transparency", by), named(name, "roughness", by)));
        Scene scene = Scenes.empty().withBackground(new Rgb(90, 120, 200)).plus(Light.at(0.1, 0.2, 4));
        for (double[] place : new double[][] {{0.2, 51 / 255.0}, {0.7, 204 / 255.0}}) {
            double share = channel.of(place[1], place[1], place[1]);
            Material same = switch (name) {
                case "diffusion" -> base.withDiffusion(share);
                case "specular" -> base.withHighlight(share, 20);
                case "reflection" -> base.withReflection(share);
                case "transparency" -> base.withTransparency(share, 1.3);
                default -> base.withRoughness(share);
            };
            assertThat(seen(scene.plus(SceneObject.of(new Rectangle(-1, -1, 1, 1)).madeOf(varied)), place[0], 0.01, Map.of()))
                    .isCloseTo(seen(scene.plus(SceneObject.of(new Rectangle(-1, -1, 1, 1)).madeOf(same)), place[0], 0.01, Map.of()), within(1e-12));
        }
        assertThat(varied.shares().all().filter(ByPattern.class::isInstance)).hasSize(1);
    }

    private static Share named(String wanted, String name, Share by) {
        return wanted.equals(name) ? by : new Even();
    }

    /** The number of a share by pattern is the greatest there is, and no other can be given. */
    @Test
    void theNumberOfAShareByPatternIsTheGreatestThereIs() {
        Shares shares = new Shares(new Even(), new Even(), new ByPattern(new Pattern.Checker(1, Vec3.ZERO, new Rgb(51, 51, 51), new Rgb(153, 153, 153))), new ByPattern(Pattern.Picture.of("p")), new Even());
        Material material = Material.DEFAULT.withShares(shares);
        assertThat(material.reflection()).isCloseTo(0.6, within(1e-12));
        assertThat(material.transparency()).isEqualTo(1);
        assertThat(material.withReflection(0.1).reflection()).isEqualTo(0.1);
        assertThat(material.withReflection(0.1).transparency()).isEqualTo(1);
        assertThat(material.files()).containsExactly("p");
        assertThatThrownBy(() -> new ByPattern(new Pattern.Plain(Rgb.WHITE))).hasMessageContaining("several colours");
    }

    /** What a checkered pane lets through stands on the wall behind it. */
    @Test
    void lightComesThroughThePlacesThatLetItThrough() {
        Shares shares = new Shares(new Even(), new Even(), new Even(), new ByPattern(new Pattern.Stripes(0.5, Rgb.BLACK, new Rgb(102, 102, 102), Lay.NONE)), new Even());
        Scene scene = Scenes.empty().plus(SunLight.along(0, 0, -1))
                .plus(SceneObject.of(new Rectangle(-5, -5, 5, 5)).at(0, 0, 10).madeOf(Material.DEFAULT.withDiffusion(0).withShares(shares)))
                .plus(SceneObject.of(new Rectangle(-5, -5, 5, 5)).madeOf(Material.DEFAULT.withDiffusion(1)));
        assertThat(seen(scene, 0.25, 0, Map.of())).isZero();
        assertThat(seen(scene, 0.75, 0, Map.of())).isCloseTo(0.4, within(1e-6));
    }

    /** What is told of a point: the place in a picture and what stands there, the number of a share, both normals; in either language. */
    @Test
    void anExplanationSaysWhatPatternsHaveAtThePoint() {
        Material material = Material.DEFAULT.withPattern(Pattern.Picture.of("p"))
                .withShares(new Shares(new Even(), new Even(), new ByPattern(ColorChannel.GREEN, new Pattern.Checker(10, Vec3.ZERO, new Rgb(0, 51, 0), Rgb.BLACK)), new Even(), new Even()))
                .withRelief(new Bump(2, BLACK_TO_WHITE));
        Scene scene = Scene.EMPTY.withSettings(new RenderSettings(1, 1, 3, 1)).withCamera(Camera.looking(new Vec3(0.3, 0.1, 5), new Vec3(0, 0, -1))).plus(Light.at(3, 4, 5))
                .withBackground(Rgb.WHITE).plus(SceneObject.of(new Rectangle(-1, -1, 1, 1)).madeOf(material));
        Pixel pixel = RenderScene.of(scene, Assets.of(Map.of("p", png(255, 255, 255))), RenderMonitor.NONE).explain(0, 0);
        Encounter met = pixel.rays().get(0).encounter().orElseThrow();
        assertThat(met.readings().stream().map(Encounter.Reading::of)).containsExactly("color", "reflection", "bump");
        Encounter.PicturePoint point = met.readings().get(0).point().orElseThrow();
        assertThat(point.file() + point.column() + point.row()).isEqualTo("p00");
        assertThat(point.u()).isCloseTo(0.65, within(1e-9));
        assertThat(point.v()).isCloseTo(0.55, within(1e-9));
        assertThat(met.material().reflection()).isCloseTo(0.2, within(1e-12));
        assertThat(met.readings().get(2).found().red()).isCloseTo(0.55, within(1e-9));
        assertThat(met.place().normal()).isEqualTo(Vec3.Z);
        assertThat(met.place().towardsViewer().y()).isCloseTo(-Math.sqrt(0.5), within(1e-9));
        assertThat(text(pixel, Locale.ENGLISH)).contains("kR             checker", "picture p", "point 0, 0 is (1, 1, 1)", "N₀, that of the surface itself");
        assertThat(text(pixel, Locale.forLanguageTag("cs"))).contains("hrbolky", "N₀, samotného povrchu");
        assertThat(TreeJson.of(pixel).toString()).contains("\"readings\":[{\"of\":\"color\",\"pattern\":\"image\",\"file\":\"p\"");
    }

    private static String text(Pixel pixel, Locale language) {
        return String.join("\n", TreeText.lines(pixel, 0, Decoration.NONE, Words.in(language)));
    }

    private interface Column {
        double at(int column);
    }

    private static byte[] png(int red, int green, int blue) {
        Image image = new Image(1, 1);
        image.set(0, 0, Rgb.linear(red), Rgb.linear(green), Rgb.linear(blue));
        return written(image);
    }

    private static byte[] png(int width, int height, Column encoded) {
        Image image = new Image(width, height);
        for (int x = 0; x < width; x++) {
            double level = Rgb.linear(encoded.at(x));
            image.set(x, 0, level, level, level);
        }
        return written(image);
    }

    private static byte[] written(Image image) {
        try {
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            ImageFiles.write(image, out, ImageFormat.PNG);
            return out.toByteArray();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
