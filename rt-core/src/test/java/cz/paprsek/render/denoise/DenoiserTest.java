package cz.paprsek.render.denoise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.image.Image;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.Tile;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.render.work.Workers;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;

/** Noise is taken out, and nothing else. Pictures with noise of a known spread are made here: what they should be is known exactly. */
class DenoiserTest {
    private static final int WIDTH = 72;
    private static final int HEIGHT = 20;
    private static final int GUIDES = 7;
    private static final double NOISE = 0.06;
    private static final double PLAIN = 0.8;

    /** A ball on a floor, in the light of a lamp that is large and near. */
    private static final Scene BALL = Scene.EMPTY.withBackground(Rgb.BLACK).withCamera(Camera.lookingAt(new Vec3(0, 1.2, 4), new Vec3(0, 0.5, 0)))
            .withLights(List.of(AreaLight.rectangle(new Vec3(1, 2, 1), 1.5, 1.5).withRotation(new Vec3(90, 0, 0))))
            .plus(SceneObject.of(new Rectangle(-3, -3, 3, 3)).rotated(-90, 0, 0)).plus(SceneObject.of(new Sphere(0.4)).at(0, 0.4, 0));

    private static double at(DoubleBinaryOperator image, int pixel) {
        int x = pixel % WIDTH;
        int y = pixel / WIDTH;
        return image.applyAsDouble(x, y);
    }

    /** A surface of a colour in some light, seen through noise: both halves of the paths are off by about {@value #NOISE}, which is known. */
    private static Noisy noisy(DoubleBinaryOperator albedo, DoubleBinaryOperator light) {
        Noisy noisy = new Noisy(WIDTH, HEIGHT, GUIDES);
        Random random = new Random(7);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            double color = at(albedo, i);
            double truth = color * at(light, i);
            for (int channel = 0; channel < Noisy.CHANNELS; channel++) {
                noisy.light[0][channel][i] = (float) (truth + NOISE * random.nextGaussian());
                noisy.light[1][channel][i] = (float) (truth + NOISE * random.nextGaussian());
                noisy.spread[channel][i] = (float) (NOISE * NOISE);
                noisy.guides[channel][i] = (float) color;
            }
        }
        return noisy;
    }

    private static Image clean(Noisy noisy) {
        Image image = new Image(WIDTH, HEIGHT);
        try (Workers workers = new Workers("denoiser-test")) {
            assertThat(Denoiser.clean(noisy, image, workers, 2, () -> false)).isTrue();
        }
        return image;
    }

    /** By how much of the noise of both halves together the picture is off. */
    private static double left(Image image, DoubleBinaryOperator truth) {
        double sum = 0;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            double off = image.green(i % WIDTH, i / WIDTH) - at(truth, i);
            sum += off * off;
        }
        return Math.sqrt(sum / (WIDTH * HEIGHT)) / (NOISE / Math.sqrt(2));
    }

    @Test
    void ofShadesLittleNoiseIsLeft() {
        DoubleBinaryOperator light = (x, y) -> 0.5 + 0.4 * Math.sin(x / 17) + y / 60;
        assertThat(left(clean(noisy((x, y) -> PLAIN, light)), (x, y) -> 0.8 * light.applyAsDouble(x, y))).isLessThan(0.36);
    }

    /** Of what a surface looks like nothing is lost, be it as fine as pixels are, and as faint as the noise. */
    @Test
    void finePatternsStay() {
        DoubleBinaryOperator weave = (x, y) -> ((int) x + (int) y / 2) % 2 == 0 ? 0.8 : 0.7;
        DoubleBinaryOperator light = (x, y) -> 0.5 + x / 150;
        Image image = clean(noisy(weave, light));
        double meant = 0;
        double kept = 0;
        for (int i = 0; i < WIDTH * HEIGHT - 1; i++) {
            double step = at(weave, i + 1) - at(weave, i);
            double shown = i % WIDTH == WIDTH - 1 ? 0 : image.red((i + 1) % WIDTH, i / WIDTH) - image.red(i % WIDTH, i / WIDTH);
            meant += i % WIDTH == WIDTH - 1 ? 0 : step * step * at(light, i);
            kept += step * shown;
        }
        assertThat(kept / meant).isCloseTo(1, within(0.1));
    }

    /** No surface tells of a shadow. */
    @Test
    void edgesOfShadowsStay() {
        DoubleBinaryOperator shadow = (x, y) -> x + y < 40 ? 0.9 : 0.3;
        Image image = clean(noisy((x, y) -> PLAIN, shadow));
        for (int y = 1; y < HEIGHT - 1; y++) {
            int edge = 40 - y;
            assertThat(image.blue(edge - 2, y) - image.blue(edge + 1, y)).isCloseTo(0.48f, within(0.16f));
        }
        assertThat(left(image, (x, y) -> 0.8 * shadow.applyAsDouble(x, y))).isLessThan(0.5);
    }

    /** A plane through what is bright leads below nothing where a guide is not as around it. */
    @Test
    void nothingIsBlackBesideWhatIsBright() {
        DoubleBinaryOperator albedo = (x, y) -> isAlone(x, y) ? 0.3 : x < WIDTH / 2.0 ? 0.5 : 0.6;
        DoubleBinaryOperator light = (x, y) -> isAlone(x, y) || x < WIDTH / 2.0 ? 0.8 : 5;
        Noisy noisy = noisy(albedo, light);
        for (float[] spread : noisy.spread) {
            Arrays.fill(spread, 4);
        }
        Image image = clean(noisy);
        for (int y = 2; y < HEIGHT; y += 7) {
            assertThat(image.green(WIDTH / 2, y)).isGreaterThan(0.1f);
        }
    }

    /** What is known well is not like what might be anything, far brighter and full of noise. */
    @Test
    void nothingBleedsOutOfWhatIsVeryBright() {
        Noisy noisy = noisy((x, y) -> PLAIN, (x, y) -> 0.02 / PLAIN);
        Random random = new Random(3);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            boolean isBright = i % WIDTH >= WIDTH / 2;
            for (int channel = 0; channel < Noisy.CHANNELS; channel++) {
                for (float[][] half : noisy.light) {
                    half[channel][i] = (float) (isBright ? 5 * Math.exp(2 * random.nextGaussian()) : 0.02 + 1e-4 * random.nextGaussian());
                }
                float apart = noisy.light[0][channel][i] - noisy.light[1][channel][i];
                noisy.spread[channel][i] = isBright ? apart * apart / 2 : 1e-8f;
            }
        }
        Image image = clean(noisy);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            if (i % WIDTH < WIDTH / 2 - 1) {
                assertThat((double) image.green(i % WIDTH, i / WIDTH)).as("%d, %d", i % WIDTH, i / WIDTH).isCloseTo(0.02, within(0.01));
            }
        }
    }

    private static boolean isAlone(double x, double y) {
        return x == WIDTH / 2.0 && y % 7 == 2;
    }

    @Test
    void whatHasNoNoiseStaysAsItIs() {
        DoubleBinaryOperator light = (x, y) -> (x * 7 + y * 13) % 10 / 10;
        Noisy exact = noisy((x, y) -> PLAIN, light);
        for (int channel = 0; channel < Noisy.CHANNELS; channel++) {
            for (int i = 0; i < WIDTH * HEIGHT; i++) {
                exact.light[0][channel][i] = (float) at(light, i);
                exact.light[1][channel][i] = exact.light[0][channel][i];
                exact.spread[channel][i] = 0;
            }
        }
        assertThat(left(clean(exact), light)).isLessThan(0.002);
    }

    private static RenderOptions options() {
        return RenderOptions.of(new RenderSettings(24, 14, 2, 1).withIntegrator(Integrator.PATH));
    }

    private static RenderResult render(RenderOptions options) {
        return Renderer.render(RenderScene.of(BALL), options, RenderMonitor.NONE);
    }

    @Test
    void thePictureIsTheSameForAnyNumberOfThreadsAndLayersStayAsTheyWereTraced() {
        List<Layer> layers = List.of(Layer.ALBEDO, Layer.INDIRECT, Layer.OBJECT);
        RenderResult traced = render(options().withLayers(layers).withTransparency());
        RenderResult denoised = render(options().withLayers(layers).withTransparency().withDenoiser().withThreads(1));
        RenderResult byThree = render(options().withTransparency().withDenoiser().withThreads(3));
        boolean differs = false;
        for (int i = 0; i < 24 * 14; i++) {
            int x = i % 24;
            int y = i / 24;
            assertThat(byThree.image().red(x, y)).isEqualTo(denoised.image().red(x, y));
            assertThat(denoised.image().alpha(x, y)).isEqualTo(traced.image().alpha(x, y));
            for (String plane : traced.layers().names()) {
                assertThat(denoised.layers().at(plane, x, y)).isEqualTo(traced.layers().at(plane, x, y));
            }
            differs |= denoised.image().red(x, y) != traced.image().red(x, y);
        }
        assertThat(differs).isTrue();
    }

    @Test
    void whoCancelsWhileNoiseIsTakenOutGetsNoPictureThatIsDone() {
        AtomicBoolean stop = new AtomicBoolean();
        RenderResult stopped = Renderer.render(RenderScene.of(BALL), options().withDenoiser(), new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return stop.get();
            }

            @Override
            public void finished(Tile tile, Image image, int done, int total) {
                stop.set(done == total);
            }
        });
        assertThat(stopped.outcome()).isEqualTo(RenderResult.Outcome.CANCELLED);
        assertThat(Thread.interrupted()).as("nobody has interrupted").isFalse();
    }

    @Test
    void whoListensIsToldWhenNoMoreIsTracedAndNoiseIsTakenOut() {
        assertThat(told(options().withDenoiser())).endsWith("finished", "denoising").containsOnlyOnce("denoising");
        assertThat(told(options())).containsOnly("finished");
    }

    private static List<String> told(RenderOptions options) {
        List<String> told = Collections.synchronizedList(new ArrayList<>());
        Renderer.render(RenderScene.of(BALL), options, new RenderMonitor() {
            @Override
            public void finished(Tile tile, Image image, int done, int total) {
                told.add("finished");
            }

            @Override
            public void denoising() {
                told.add("denoising");
            }
        });
        return told;
    }

    @Test
    void whatCannotBeDenoisedIsRefusedWithASentence() {
        RenderOptions whitted = RenderOptions.of(RenderSettings.DEFAULT);
        assertThatThrownBy(whitted::withDenoiser).hasMessageContaining("integrator path");
        RenderOptions broken = options().withSettings(options().settings().withSamples(100));
        assertThatThrownBy(broken::withDenoiser).hasMessageContaining("multiple of 64, not 100");
        RenderOptions part = options().withRegion(new Tile(0, 0, 10, 10));
        assertThatThrownBy(part::withDenoiser).hasMessageContaining("whole picture");
        RenderOptions counts = options().withMode(RenderMode.SAMPLES);
        assertThatThrownBy(counts::withDenoiser).hasMessageContaining("not of samples");
    }
}
