package cz.paprsek.render.integrate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.explain.LightTerm;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.sample.PixelSums;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.placed.Spans;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What becomes of a ray on its way: where it goes on, what it counts, when it stops, what it sees of lamps; each by itself. */
class FollowedRaysTest {
    private static final Material CLEAR = Material.color(Rgb.BLACK).withDiffusion(0).withHighlight(0, 1);
    private static final Material MIRROR = CLEAR.withReflection(1);

    private static World world(Scene scene) {
        return new World(scene, new Textures(Assets.none()), () -> false);
    }

    private static Whitted tracer(Scene scene, int depth) {
        Whitted tracer = new Whitted(world(scene), depth, Sampling.grid(1));
        tracer.begin(() -> false);
        return tracer;
    }

    private static Level traced(Whitted tracer, Vec3 origin, Vec3 direction) {
        tracer.startAlone(origin, direction.normalized());
        tracer.traceAlone();
        return tracer.alone();
    }

    private static SceneObject wall(double z, Material material) {
        return SceneObject.of(new Rectangle(-9, -9, 9, 9)).at(0, 0, z).madeOf(material);
    }

    private static SceneObject slab(double from, double to, Material material) {
        return SceneObject.of(new Block(new Vec3(-50, -50, from), new Vec3(50, 50, to))).madeOf(material);
    }

    /** N = (2, 3, 6)/7. A direction on the wrong side of a bent surface has its part along N turned round: d − 2(d·N)N. */
    @ParameterizedTest
    @CsvSource({"true, 0.6, 0, 0.8", "false, -0.6, 0, -0.8", "true, 0.48, -0.6, 0.64", "true, -0.48, -0.6, -0.64", "false, 0.48, 0.6, 0.64"})
    void aRayThatLeavesABentSurfaceIsFoldedToItsSide(boolean isThrough, double x, double y, double z) {
        World world = world(Scene.EMPTY.plus(wall(0, CLEAR.withTransparency(1, 1.5))));
        Level level = new Level(new Spans());
        level.ray.start(2, 3, 9, -0.6, 0, -0.8);
        level.ray.accept(5, world.parts().firstOf(0), 0);
        level.hit.px = 1;
        level.hit.py = 2;
        level.hit.pz = 4;
        level.hit.unitNormal(2.0 / 7, 3.0 / 7, 6.0 / 7);
        level.hit.bend(0, 0, 1);
        level.isBent = true;
        Level next = new Level(new Spans());
        Offspring offspring = new Offspring(world);
        Vec3 n = new Vec3(2.0 / 7, 3.0 / 7, 6.0 / 7);
        Vec3 d = new Vec3(x, y, z);
        if (isThrough) {
            offspring.on(level, next, world.parts().finish(level.ray.part), x, y, z);
        } else {
            offspring.back(level, next, x, y, z);
        }
        boolean isOnItsSide = d.dot(n) < 0 == isThrough;
        Vec3 expected = isOnItsSide ? d : d.minus(n.times(2 * d.dot(n)));
        assertThat(new Vec3(next.ray.dx, next.ray.dy, next.ray.dz).minus(expected).length()).isLessThan(1e-15);
        assertThat(new double[] {next.ray.ox, next.ray.oy, next.ray.oz}).containsExactly(1, 2, 4);
        assertThat(next.beyond).isEqualTo(isThrough);
        assertThat(offspring.refracted - offspring.reflected).isEqualTo(isThrough ? 1 : -1);
        level.isBent = false;
        offspring.on(level, next, world.parts().finish(level.ray.part), x, y, z);
        assertThat(new double[] {next.ray.dx, next.ray.dy, next.ray.dz}).as("as it is where nothing is bent").containsExactly(x, y, z);
    }

    /** The eye touches glass of index n: neighbouring rays are 1/n as far apart there, as those of a lens with tan(fovy/2)/n are in air. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1.5, 2})
    void neighboursOfARayAreBentAsItIs(double index) throws IOException {
        Assets assets = edge();
        double tangent = Math.tan(Math.toRadians(8));
        double through = smooth(pictureAt(-4).plus(slab(-5, 0, CLEAR.withTransparency(1, index))), assets, 0, tangent);
        assertThat(through).isBetween(0.55, 0.95);
        assertThat(through).isCloseTo(smooth(pictureAt(-4), assets, 0, tangent / index), within(5e-3));
    }

    /** In a flat mirror a picture is as smooth as from afar. */
    @Test
    void neighboursOfARayAreMirroredAsItIs() throws IOException {
        Assets assets = edge();
        double tangent = Math.tan(Math.toRadians(8));
        double mirrored = smooth(pictureAt(3).plus(wall(0, MIRROR)), assets, 1, tangent);
        assertThat(mirrored).isBetween(0.55, 0.95);
        assertThat(mirrored).isCloseTo(smooth(pictureAt(-4), assets, 0, tangent), within(5e-3));
    }

    /** Black on the left, white on the right. */
    private static Assets edge() throws IOException {
        Image edge = new Image(64, 64);
        for (int i = 0; i < 64 * 64; i++) {
            double light = i % 64 < 32 ? 0 : 1;
            edge.set(i % 64, i / 64, light, light, light);
        }
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageFiles.write(edge, png, ImageFormat.PNG);
        return Assets.of(Map.of("p", png.toByteArray()));
    }

    private static Scene pictureAt(double z) {
        Material picture = Material.DEFAULT.withDiffusion(0).withHighlight(0, 1).withPattern(Pattern.Picture.of("p"));
        return Scene.EMPTY.withAmbient(Rgb.WHITE).plus(SceneObject.of(new Rectangle(-2, -2, 2, 2)).at(0, 0, z).madeOf(picture));
    }

    private static double smooth(Scene scene, Assets assets, double z, double tangent) {
        Whitted tracer = new Whitted(new World(scene, new Textures(assets), () -> false), 4, Sampling.grid(1));
        tracer.begin(() -> false);
        Camera camera = Camera.looking(new Vec3(0.1, 0, z + 1e-6), new Vec3(0, 0, -1)).withFovy(2 * Math.toDegrees(Math.atan(tangent)));
        tracer.startAlone(Eye.of(camera, 1, 1), 0.5, 0.5);
        tracer.traceAlone();
        return tracer.alone().red;
    }

    /** Through a pane to a mirror and back to the sky: four rays each. Of 64 rays one asks whether to stop. */
    @Test
    void everyKindOfRayCounts() {
        Scene scene = Scene.EMPTY.withBackground(Rgb.WHITE).plus(wall(0, CLEAR.withTransparency(1, 1))).plus(wall(-1, MIRROR));
        Whitted tracer = tracer(scene, 5);
        int[] asked = {0};
        tracer.begin(() -> ++asked[0] == 2);
        for (int i = 1; i <= 32; i++) {
            assertThat(traced(tracer, new Vec3(0, 0, 5), new Vec3(0, 0.1, -1)).red).isEqualTo(i == 32 ? 0 : 1);
            assertThat(asked[0]).isEqualTo(i / 16);
        }
        assertThat(tracer.work()).isEqualTo(new Integrator.Work(32, 32, 64, 0, 96));
        assertThat(tracer.rays()).isEqualTo(128);
    }

    /** From within glass into more of the same that touches it, at an angle of which nothing would get out into air: straight on, to what shines there. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void betweenSlabsThatTouchNothingIsMirrored(boolean isNearFirst) {
        Material glass = CLEAR.withTransparency(1, 1.5);
        SceneObject near = slab(-1, 0, glass);
        SceneObject far = slab(-2, -1, glass);
        Scene scene = Scene.EMPTY.plus(wall(-1.5, CLEAR.withEmission(Rgb.WHITE, 0.7)));
        Whitted tracer = tracer(isNearFirst ? scene.plus(near).plus(far) : scene.plus(far).plus(near), 8);
        assertThat(traced(tracer, new Vec3(0, 0, -0.5), new Vec3(0.9, 0, -0.4)).red).isEqualTo(0.7);
        assertThat(new long[] {tracer.work().reflected(), tracer.work().refracted(), tracer.work().hits()}).as("the one entered, the other left").containsExactly(0, 2, 3);
    }

    /** d − 2(d·N)N, of a ball about the origin. */
    @Test
    void aBallMirrorsAboutItsNormal() {
        Whitted tracer = tracer(Scene.EMPTY.plus(SceneObject.of(new Sphere(1)).madeOf(MIRROR)), 1);
        Random random = new Random(8);
        for (int i = 0; i < 50; i++) {
            Vec3 n = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5).normalized();
            Vec3 from = n.times(2).plus(new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5));
            Vec3 d = n.minus(from).normalized();
            Level level = traced(tracer, from, d);
            Vec3 expected = d.minus(n.times(2 * d.dot(n)));
            assertThat(new double[] {level.mirrorX, level.mirrorY, level.mirrorZ}).containsExactly(new double[] {expected.x(), expected.y(), expected.z()}, within(1e-12));
            assertThat(level.cosine).isCloseTo(-d.dot(n), within(1e-12));
        }
    }

    /** What lies in one place with a mirror, and counts after it, does not hide what is mirrored. */
    @Test
    void whatTouchesAMirrorIsNotSeenInIt() {
        Whitted tracer = tracer(Scene.EMPTY.withBackground(Rgb.WHITE).plus(wall(0, MIRROR)).plus(wall(0, CLEAR)), 8);
        assertThat(traced(tracer, new Vec3(0.1, 0.2, 5), new Vec3(0.1, 0.2, -1)).red).isEqualTo(1);
    }

    /** Each of two panes in one place is gone through once. */
    @Test
    void panesInOnePlaceAreMetOnceEach() {
        Material pane = CLEAR.withTransparency(0.5, 1);
        Whitted tracer = tracer(Scene.EMPTY.withBackground(Rgb.WHITE).plus(wall(0, pane)).plus(wall(0, pane)), 8);
        assertThat(traced(tracer, new Vec3(0, 0, 5), new Vec3(0.1, 0.2, -1)).red).isEqualTo(0.25);
        assertThat(tracer.work().refracted()).isEqualTo(2);
    }

    /** A lamp shines through three panes: the product of their shares, the smallest first, whatever the order they stand in. */
    @ParameterizedTest
    @CsvSource({"0.1, 0.3, 0.7", "0.7, 0.3, 0.1", "0.3, 0.7, 0.1", "0.7, 0.1, 0.3", "0.1, 0.7, 0.3", "0.3, 0.1, 0.7"})
    void sharesOfPanesAreMultipliedFromTheSmallestOn(double one, double two, double three) {
        Scene scene = Scene.EMPTY.plus(SunLight.along(0, 0, -1)).plus(wall(0, CLEAR.withPattern(new Pattern.Plain(Rgb.WHITE)).withDiffusion(1)));
        double z = 1;
        for (double share : new double[] {one, two, three}) {
            scene = scene.plus(wall(z++, CLEAR.withTransparency(share, 1)));
        }
        assertThat(traced(tracer(scene, 1), new Vec3(0, 0, 0.5), new Vec3(0, 0, -1)).red).isEqualTo(0.1 * 0.3 * 0.7);
    }

    /** Nothing of the scene is between the floor and a lamp, but another lamp, which has a body. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void theBodyOfALampHidesOtherLamps(boolean isVisible) {
        Scene scene = Scene.EMPTY.withCamera(Camera.looking(new Vec3(0, 0, 5), new Vec3(0, 0, -1)))
                .plus(Light.at(0, 3, 3)).plus(SphereLight.of(new Vec3(0, 1.5, 1.5), 0.2).withIntensity(1e-9).withVisible(isVisible))
                .plus(wall(0, CLEAR.withPattern(new Pattern.Plain(Rgb.WHITE)).withDiffusion(1)));
        double light = tracer(among(scene, 1), 1).pixel(Eye.of(scene.camera(), 1, 1), 0, 0).red;
        assertThat(light).isCloseTo(isVisible ? 0 : Math.sqrt(0.5), within(1e-6));
    }

    /** A ball of the scene, on any scale. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e6, 1e-6})
    void aBallHidesALampOnAnyScale(double scale) {
        Scene scene = Scene.EMPTY.withCamera(Camera.looking(new Vec3(0, 0, 5 * scale), new Vec3(0, 0, -1))).plus(Light.at(0, 3 * scale, 3 * scale).withReferenceDistance(scale))
                .plus(SceneObject.of(new Rectangle(-9, -9, 9, 9)).scaled(scale, scale, scale).madeOf(CLEAR.withPattern(new Pattern.Plain(Rgb.WHITE)).withDiffusion(1)));
        Eye eye = Eye.of(scene.camera(), 1, 1);
        assertThat(tracer(among(scene, scale), 1).pixel(eye, 0, 0).red).isPositive();
        assertThat(tracer(among(scene.plus(SceneObject.of(new Sphere(0.2 * scale)).at(0, 1.5 * scale, 1.5 * scale)), scale), 1).pixel(eye, 0, 0).red).isZero();
    }

    /** Tinted glass over the left half of a floor: nothing of it stays for the next pixel, whose light meets none. */
    @Test
    void whatTookLightOnOneWayTakesNoneOnTheNext() {
        Scene scene = Scene.EMPTY.withCamera(Camera.looking(new Vec3(0, 0, 0.5), new Vec3(0, 0, -1)).withFovy(120)).plus(SunLight.along(0, 0, -1))
                .plus(wall(0, CLEAR.withPattern(new Pattern.Plain(Rgb.WHITE)).withDiffusion(1)))
                .plus(SceneObject.of(new Block(new Vec3(-5, -5, 1), new Vec3(-0.1, 5, 2))).madeOf(CLEAR.withTransparency(1, 1).withAttenuation(Rgb.ofLinear(0.5, 0.5, 0.5), 1)));
        Whitted tracer = tracer(among(scene, 1), 1);
        Eye eye = Eye.of(scene.camera(), 2, 1);
        assertThat(tracer.pixel(eye, 0, 0).red).isCloseTo(Math.exp(-0.5), within(1e-6));
        assertThat(tracer.pixel(eye, 1, 0).red).isEqualTo(1);
    }

    /** So many bodies where no ray goes that there is a tree, of which rays that go together leave out parts. */
    private static Scene among(Scene scene, double scale) {
        for (int i = 0; i < 40; i++) {
            scene = scene.plus(SceneObject.of(new Sphere(0.2 * scale)).at((i % 7 - 3) * scale, (i / 7 - 3) * scale, (-20 - i) * scale));
        }
        return scene;
    }

    /** Beside its lobe, of which all channels are alike, a rough surface has the diffuse part and the highlight of every other: kD·C·I·cos θ + kS·I·(R·L)², from before only. */
    @ParameterizedTest
    @ValueSource(doubles = {1, -1})
    void aRoughSurfaceIsDiffuseToo(double side) {
        Material rough = Material.color(Rgb.ofLinear(0.2, 0.4, 0.8)).withReflection(0.5).withRoughness(0.5);
        double[] lobe = lit(rough.withDiffusion(0).withHighlight(0, 1), side);
        double[] both = lit(rough.withDiffusion(0.6).withHighlight(0.3, 2), side);
        for (int i = 0; i < 3; i++) {
            double color = 0.2 * (1 << i);
            assertThat(lobe[i]).isEqualTo(lobe[0]);
            assertThat(both[i] - lobe[i]).isCloseTo(side > 0 ? 0.6 * color * 0.8 + 0.3 * 0.64 : 0, within(1e-12));
        }
        assertThat(lobe[0] > 0).isEqualTo(side > 0);
    }

    private static double[] lit(Material material, double side) {
        Scene scene = Scene.EMPTY.plus(SunLight.along(-0.6, 0, -0.8 * side)).plus(wall(0, material));
        Level level = traced(tracer(scene, 1), new Vec3(0, 0, 1), new Vec3(0, 0, -1));
        return new double[] {level.red, level.green, level.blue};
    }

    /** A lamp behind a rough pane: what stands before it hides it. */
    @Test
    void throughARoughPaneALampIsHiddenByWhatStandsBehindIt() {
        Scene scene = Scene.EMPTY.plus(Light.at(0.2, 0.1, -4)).plus(wall(0, CLEAR.withTransparency(0.9, 1).withRoughness(0.6)));
        assertThat(traced(tracer(scene, 1), new Vec3(0, 0, 3), new Vec3(0, 0, -1)).red).isPositive();
        assertThat(traced(tracer(scene.plus(wall(-2, CLEAR)), 1), new Vec3(0, 0, 3), new Vec3(0, 0, -1)).red).isZero();
    }

    /** A lamp that a rough surface turns away from is told, too: with its cosine, and that nothing of it comes. */
    @Test
    void aLampBehindARoughSurfaceIsTold() {
        Scene scene = Scene.EMPTY.plus(Light.at(0, 3, -4)).plus(wall(0, Material.DEFAULT.withReflection(0.3).withRoughness(0.5)));
        LightTerm term = RenderScene.of(scene).explainRay(new Vec3(0, 0, 1), new Vec3(0, 0, -1), 1).encounter().orElseThrow().lights().get(0);
        assertThat(term.rays()).singleElement().satisfies(ray -> assertThat(ray.facing()).isCloseTo(-0.8, within(1e-12)));
        assertThat(term.added().red()).isZero();
    }

    /** What a ray sees of a lamp that is a ball, whose normals are on the ray's side: from outside its radiance I·D²/r², from inside nothing. */
    @Test
    void aBallOfLightIsAsBrightFromEverySide() {
        Whitted tracer = tracer(Scene.EMPTY.plus(SphereLight.of(new Vec3(1, 2, 3), 0.5).withIntensity(0.3).withVisible(true)), 2);
        Random random = new Random(5);
        for (int i = 0; i < 100; i++) {
            Vec3 away = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5).normalized();
            Vec3 aside = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5).times(0.4);
            Vec3 middle = new Vec3(1, 2, 3).plus(aside);
            Level level = traced(tracer, middle.plus(away.times(7)), away.times(-1));
            assertThat(level.red).isCloseTo(1.2, within(1e-12));
            assertThat(level.hit.nx * away.x() + level.hit.ny * away.y() + level.hit.nz * away.z()).isPositive();
            level = traced(tracer, middle, away);
            assertThat(level.red).isZero();
            assertThat(level.hit.nx * away.x() + level.hit.ny * away.y() + level.hit.nz * away.z()).as("turned to who sees it").isNegative();
        }
    }

    /** A rectangle shines to one side only. */
    @Test
    void aRectangleOfLightIsBlackFromBehind() {
        Whitted tracer = tracer(Scene.EMPTY.plus(AreaLight.rectangle(Vec3.ZERO, 2, 1).withVisible(true)), 2);
        double[] seen = {traced(tracer, new Vec3(0, 0, 5), new Vec3(0.01, 0.02, -1)).red, traced(tracer, new Vec3(0, 0, -5), new Vec3(0.01, 0.02, 1)).red};
        assertThat(Math.min(seen[0], seen[1])).isZero();
        assertThat(Math.max(seen[0], seen[1])).isCloseTo(Math.PI / 2, within(1e-12));
    }

    /** I/sin²(angle/2) within the disc, the background beside it; the background, too, where the sun was looked for already. */
    @Test
    void theDiscOfASunIsSeenUnlessItWasLookedFor() {
        Scene scene = Scene.EMPTY.withBackground(Rgb.WHITE).plus(SunLight.along(0, 0, -1).withDisc(60, true).withIntensity(0.5));
        Whitted tracer = tracer(scene, 2);
        assertThat(traced(tracer, Vec3.ZERO, new Vec3(0.5, 0, 1)).red).isCloseTo(2, within(1e-12));
        assertThat(traced(tracer, Vec3.ZERO, new Vec3(0.6, 0, 1)).red).isEqualTo(1);
        tracer.startAlone(Vec3.ZERO, Vec3.Z);
        tracer.findAlone();
        tracer.alone().isLit = true;
        tracer.shade(tracer.alone(), 0);
        assertThat(tracer.alone().red).isEqualTo(1);
        tracer.alone().isLit = false;
        tracer.shade(tracer.alone(), 0);
        assertThat(tracer.alone().red).isCloseTo(2, within(1e-12));
    }

    /** Rays of a block are traced together; so are those that a pixel gets at first, and those it gets beyond. It makes no difference to any bit. */
    @ParameterizedTest
    @CsvSource({"2, 0, MITCHELL, 1", "2, 6, BOX, 1", "1, 0, BOX, 1e6", "2, 4, GAUSS, 1e-6"})
    void raysBringTheSameTogetherAndAlone(int least, int most, PixelFilter filter, double scale) {
        RenderSettings settings = RenderSettings.DEFAULT.withSize(8, 6).withMaxDepth(3).withFilter(filter);
        settings = most == 0 ? settings.withSamples(least) : settings.withSamples(least, most);
        Scene scene = balls(scale).withSettings(settings);
        Sampling sampling = Sampling.of(settings, false);
        Whitted tracer = new Whitted(world(scene), 3, sampling);
        tracer.begin(() -> false);
        Eye eye = Eye.of(scene.camera(), 8, 6);
        Image image = new Image(8, 6);
        tracer.block(eye, 0, 0, 8, 6, new Film(image, 0, 0));
        int beyond = 0;
        for (int i = 0; i < 48; i++) {
            PixelSums sums = tracer.pixel(eye, i % 8, i / 8);
            double[] together = {sums.red, sums.green, sums.blue};
            int count = sums.count();
            assertThat(new float[] {image.red(i % 8, i / 8), image.green(i % 8, i / 8), image.blue(i % 8, i / 8)})
                    .containsExactly((float) together[0], (float) together[1], (float) together[2]);
            assertThat(tracer.eachAlone(eye, i % 8, i / 8)).isEqualTo(count);
            sums.mean();
            assertThat(new double[] {sums.red, sums.green, sums.blue}).as("pixel %d", i).containsExactly(together);
            beyond += count > sampling.rays() ? 1 : 0;
        }
        assertThat(beyond > 0).isEqualTo(most > least);
    }

    private static Scene balls(double scale) {
        Random random = new Random(3);
        Scene scene = Scene.EMPTY.withBackground(new Rgb(60, 90, 140)).withCamera(Camera.looking(new Vec3(0, 0, 5 * scale), new Vec3(0, 0, -1)))
                .plus(SphereLight.of(new Vec3(0, 4, 3).times(scale), 0.5 * scale).withSamples(3).withReferenceDistance(4 * scale))
                .plus(SphereLight.of(new Vec3(4, 0, 3).times(scale), scale).withSamples(1).withReferenceDistance(scale));
        for (int i = 0; i < 60; i++) {
            Material material = i % 3 == 0 ? Material.DEFAULT : Material.color(200, 90, 3 * i).withReflection(0.3).withRoughness(i % 3 == 1 ? 0.5 : 0);
            scene = scene.plus(SceneObject.of(new Sphere(0.1 * scale)).at((3 * random.nextDouble() - 2) * scale, (2 * random.nextDouble() - 1.5) * scale, random.nextDouble() * scale).madeOf(material));
        }
        return scene;
    }
}
