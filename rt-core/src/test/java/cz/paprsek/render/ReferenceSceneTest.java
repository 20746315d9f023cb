package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A scene of Phong, glass, mirror, checker, difference and two lights, with the values that POV-Ray 3.7 gives for it. */
class ReferenceSceneTest {
    private static final Image IMAGE = Renderer.render(scene());

    /** The values are 16-bit linear; two steps are allowed. */
    @ParameterizedTest
    @CsvSource({
        "0, 0, 6554, 13107, 19661",
        "12, 20, 18194, 6841, 4571",
        "20, 20, 32380, 15148, 11702",
        "40, 26, 14856, 23282, 17766",
        "44, 22, 22137, 24538, 24739",
        "41, 33, 9121, 12453, 18057",
        "48, 14, 7005, 21015, 9340",
        "50, 20, 1536, 3071, 6910",
        "30, 40, 4781, 6419, 8058",
        "8, 34, 3423, 5061, 6700"})
    void pixelHasTheValueThatPovRayGives(int x, int y, int red, int green, int blue) {
        assertThat(new long[] {step(IMAGE.red(x, y)) - red, step(IMAGE.green(x, y)) - green, step(IMAGE.blue(x, y)) - blue})
                .as("difference in 16-bit steps")
                .satisfies(d -> assertThat(d[0]).isBetween(-2L, 2L))
                .satisfies(d -> assertThat(d[1]).isBetween(-2L, 2L))
                .satisfies(d -> assertThat(d[2]).isBetween(-2L, 2L));
    }

    private static long step(float linear) {
        return Math.round(Math.min(1, linear) * 65535);
    }

    static Scene scene() {
        Material ball = matte(0.8, 0.3, 0.2, 0.7).withHighlight(0.5, 30);
        Material glass = matte(0.9, 1, 0.9, 0.2).withHighlight(0.3, 50).withReflection(0.1).withTransparency(0.6, 1.5);
        Material tiles = Material.DEFAULT.withDiffusion(0.6).withReflection(0.25).withPattern(
                new Pattern.Checker(1, Vec3.ZERO, Rgb.WHITE, Rgb.ofLinear(0.2, 0.2, 0.2)));
        return Scene.EMPTY
                .withSettings(new RenderSettings(64, 48, 8, 1))
                .withBackground(Rgb.ofLinear(0.1, 0.2, 0.3))
                .withCamera(Camera.looking(new Vec3(0, 2.5, 6), new Vec3(0, -0.25, -1)).withFovy(40))
                .plus(Light.at(4, 6, 5).withIntensity(0.7))
                .plus(Light.at(-3, 5, 2).withIntensity(0.25))
                .plus(SceneObject.of(new Sphere(1)).at(-1.2, 1, 0).madeOf(ball),
                        SceneObject.of(new Sphere(0.7)).at(0.9, 0.8, 1).madeOf(glass),
                        SceneObject.of(Csg.difference(
                                        Operand.of(new Block(new Vec3(0.5, -0.2, -3), new Vec3(2.5, 1.6, -1))),
                                        Operand.of(new Sphere(0.7)).at(1.5, 1, -1).madeOf(matte(0.2, 0.4, 0.9, 0.6))))
                                .madeOf(matte(0.3, 0.9, 0.4, 0.8)),
                        // 8 × 7 squares of 0.75 × 1: a checker of unit cubes on a block stretched by 0.75 along x.
                        SceneObject.of(new Block(new Vec3(-4, -0.5, -4), new Vec3(4, -0.2, 3)))
                                .scaled(0.75, 1, 1).madeOf(tiles.withPattern(
                                        new Pattern.Checker(1, new Vec3(-4, -0.5, -4), Rgb.WHITE, Rgb.ofLinear(0.2, 0.2, 0.2)))));
    }

    private static Material matte(double red, double green, double blue, double diffusion) {
        return Material.color(Rgb.ofLinear(red, green, blue)).withDiffusion(diffusion);
    }
}
