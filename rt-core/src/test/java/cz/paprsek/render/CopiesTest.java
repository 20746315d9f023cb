package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.render.surface.World;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.copied.Copy;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A body that stands in many places is placed once, and the pictures are those of a scene in which each has its own. */
class CopiesTest {
    private static final int PLACES = 257;
    private static final Material GLASS = Material.color(240, 250, 255).withDiffusion(0.1).withTransparency(0.9, 1.4);
    private static final Scene SHARED = scene(false);
    private static final Scene APART = scene(true);
    private static final RenderScene READY = RenderScene.of(SHARED);
    private static final RenderScene READY_APART = RenderScene.of(APART);

    private static Scene scene(boolean apart) {
        Random random = new Random(5);
        List<SceneObject> objects = new ArrayList<>();
        objects.add(SceneObject.of(new Plane()).at(0, -4, 0).madeOf(Scenes.matte(0.5, 0.8)));
        for (int i = 0; i < PLACES; i++) {
            Csg cluster = cluster(apart ? i + 1 : 0);
            SceneObject object = SceneObject.of(i % 5 == 0 ? Csg.difference(Operand.of(cluster).at(0, 0.1, 0), Operand.of(new Block(new Vec3(-2, 0.3, -2), new Vec3(2, 2, 2)))) : cluster);
            objects.add(object.at(random.nextDouble() * 10 - 5, random.nextDouble() * 6 - 3, random.nextDouble() * 10 - 10)
                    .rotated(random.nextInt(360), random.nextInt(360), random.nextInt(360))
                    .scaled(0.5 + random.nextDouble(), 0.5 + random.nextDouble(), 0.5 + random.nextDouble())
                    .madeOf(i % 7 == 0 ? new MaterialName("red") : i % 11 == 0 ? GLASS : Scenes.matte(0.1 + 0.003 * i, 0.9)));
        }
        return Scenes.empty().withSettings(new RenderSettings(33, 25, 6, 1)).withMaterials(Map.of("red", Material.color(200, 30, 20).withReflection(0.3)))
                .withCamera(Camera.lookingAt(new Vec3(0, 1, 6), new Vec3(0, 0, -5))).withObjects(objects).withBackground(new Rgb(60, 90, 140)).withAmbient(Rgb.grey(40))
                .plus(Light.at(5, 6, 6).withIntensity(0.6)).plus(Light.at(-6, 4, 3).withIntensity(0.4));
    }

    /** 256 balls, some of which have a material of their own. */
    private static Csg cluster(int apart) {
        Random random = new Random(3);
        List<Operand> balls = new ArrayList<>();
        for (int i = 0; i < 256; i++) {
            Operand ball = Operand.of(new Sphere(0.03 + 0.15 * random.nextDouble())).at(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5)
                    .madeOf(material(i));
            balls.add(i == 0 ? aside(ball, apart) : ball);
        }
        return Csg.union(balls.toArray(Operand[]::new));
    }

    /** Moved by less than can be seen, but not equal to others any more. */
    private static Operand aside(Operand operand, int by) {
        Placement placement = operand.placement();
        return operand.placed(placement.withPosition(placement.position().plus(new Vec3(0, 1e-13 * by, 0))));
    }

    private static MaterialSource material(int i) {
        return switch (i % 8) {
            case 0 -> new MaterialName("red");
            case 1 -> Scenes.matte(0.7, 0.6).withPattern(new Pattern.Checker(0.1, Vec3.ZERO, Rgb.WHITE, Rgb.grey(30)));
            case 2 -> Scenes.matte(0.2, 0.9);
            case 3 -> Scenes.matte(0.4, 0.5).withEmission(new Rgb(255, 180, 60), 1.5);
            default -> Inherited.INHERITED;
        };
    }

    @ParameterizedTest
    @EnumSource(value = RenderMode.class, names = {"SHADED", "OBJECTS", "NORMALS", "UV"})
    void picturesAreThoseOfBodiesPlacedOneByOne(RenderMode mode) {
        assertAlike(picture(READY, RenderOptions.of(SHARED).withMode(mode)), picture(READY_APART, RenderOptions.of(APART).withMode(mode)));
    }

    @Test
    void pathsAreThose() {
        RenderSettings settings = SHARED.settings().withIntegrator(RenderSettings.Integrator.PATH).withSamples(4);
        assertAlike(picture(READY, RenderOptions.of(SHARED).withSettings(settings)), picture(READY_APART, RenderOptions.of(APART).withSettings(settings)));
    }

    private static Image picture(RenderScene scene, RenderOptions options) {
        return Renderer.render(scene, options, RenderMonitor.NONE).image();
    }

    private static void assertAlike(Image image, Image expected) {
        assertThat(Scenes.difference(image, expected, 1e-6)).isLessThanOrEqualTo(0.005);
    }

    @Test
    void itIsPlacedOnce() {
        for (int i = 1; i <= PLACES; i++) {
            assertThat(READY_APART.world().surface(i)).isNotInstanceOf(Copy.class);
            if (READY.world().surface(i) instanceof Copy copy) {
                assertThat(copy.original()).isSameAs(((Copy) READY.world().surface(2)).original());
            } else {
                assertThat((i - 1) % 5).as("a copy as an operand").isZero();
            }
        }
        assertThat(READY.world().parts().end()).as("each part of each place has a number").isEqualTo(READY_APART.world().parts().end());
    }

    @Test
    void explanationsAndPicksTellWhichBodyOfWhichCopyItIs() {
        int copies = 0;
        for (int y = 0; y < 25; y++) {
            int x = y * 7 % 33;
            Optional<ScenePath> place = RenderScene.Pick.at(READY, SHARED.settings(), x + 0.5, y + 0.5).map(RenderScene.Pick::place);
            assertThat(place).isEqualTo(RenderScene.Pick.at(READY_APART, APART.settings(), x + 0.5, y + 0.5).map(RenderScene.Pick::place));
            copies += place.filter(one -> one instanceof ScenePath.BodyAt at && at.depth() > 0).isPresent() ? 1 : 0;
            assertThat(surface(READY, x, y)).isEqualTo(surface(READY_APART, x, y));
        }
        assertThat(copies).isGreaterThan(10);
    }

    private static Optional<ScenePath> surface(RenderScene scene, int x, int y) {
        return scene.explain(x, y).rays().get(0).encounter().map(met -> met.place().surface().part().object());
    }

    /** What the inside takes of light is what the first part does that light gets through, not what the material around would. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 255})
    void theInsideOfACopyIsThatOfItsFirstPart(int lastOfBlue) {
        assertAlikeCopied(apart -> inRows(balls(i -> i <= lastOfBlue ? tinted(40, 40, 255) : Inherited.INHERITED), apart, tinted(255, 40, 40)));
    }

    /** What is flush with a body of glass is met in its own order, whatever the unused material around. */
    @Test
    void aCopyOfOpaquePartsIsOpaqueInAnObjectOfGlass() {
        Scene flush = assertAlikeCopied(apart -> inRows(blocks(), apart, tinted(255, 40, 40))
                .plus(SceneObject.of(new Block(new Vec3(-6, 0.05, -9), new Vec3(6, 0.3, 2))).madeOf(tinted(40, 40, 255))));
        World world = RenderScene.of(flush).world();
        assertThat(world.isMedium(0)).isFalse();
        assertThat(world.isMedium(PLACES)).isTrue();
    }

    private static Material tinted(int red, int green, int blue) {
        return Material.color(255, 255, 255).withDiffusion(0.05).withTransparency(0.95, 1.2).withAttenuation(new Rgb(red, green, blue), 0.05);
    }

    private static Csg balls(IntFunction<MaterialSource> materials) {
        List<Operand> all = new ArrayList<>();
        for (int i = 0; i < 256; i++) {
            all.add(Operand.of(new Sphere(0.9)).at(i % 16 - 8, i % 3 * 0.5, i / 16 - 8).madeOf(materials.apply(i)));
        }
        return Csg.union(all.toArray(Operand[]::new));
    }

    private static Csg blocks() {
        List<Operand> all = new ArrayList<>();
        for (int i = 0; i < 256; i++) {
            all.add(Operand.of(new Block(new Vec3(0, 0, 0), new Vec3(1, 1, 1))).at(i % 16 - 8, 0, i / 16 - 8).madeOf(Scenes.matte(0.7, 0.6)));
        }
        return Csg.union(all.toArray(Operand[]::new));
    }

    private static Scene inRows(Csg body, boolean apart, Material material) {
        List<SceneObject> objects = new ArrayList<>();
        for (int i = 0; i < PLACES; i++) {
            List<Operand> own = new ArrayList<>(body.operands());
            own.set(0, aside(own.get(0), apart ? i + 1 : 0));
            objects.add(SceneObject.of(new Csg(body.operation(), own)).scaled(0.05, 0.05, 0.05).at((i % 16 - 8) * 0.8, 0, -(i / 16) * 0.8).madeOf(material));
        }
        return Scenes.empty().withSettings(new RenderSettings(33, 25, 6, 1)).withCamera(Camera.lookingAt(new Vec3(0, 1, 6), new Vec3(0, 0, -5))).withObjects(objects)
                .withBackground(new Rgb(60, 90, 140)).withAmbient(Rgb.grey(40)).plus(Light.at(5, 6, 6).withIntensity(0.6));
    }

    /** @param scene makes one whose bodies differ if that is asked for, else not */
    private static Scene assertAlikeCopied(Function<Boolean, Scene> scene) {
        Scene shared = scene.apply(false);
        Scene apart = scene.apply(true);
        RenderScene ready = RenderScene.of(shared);
        RenderScene readyApart = RenderScene.of(apart);
        assertThat(ready.world().surface(0)).isInstanceOf(Copy.class);
        assertThat(readyApart.world().surface(0)).isNotInstanceOf(Copy.class);
        assertAlike(picture(ready, RenderOptions.of(shared)), picture(readyApart, RenderOptions.of(apart)));
        return shared;
    }

    @Test
    void afterChangesPicturesAreThoseOfAFreshScene() {
        RenderScene ready = READY;
        Scene scene = SHARED;
        for (ScenePath.BodyAt at : List.of(ScenePath.body(0), ScenePath.body(9), ScenePath.body(16))) {
            scene = scene.with(at, body -> body.placed(body.placement().withPosition(new Vec3(0.25, -3.5, 0))));
            ready = ready.changedTo(scene, RenderMonitor.NONE);
            RenderScene fresh = RenderScene.of(scene);
            for (RenderMode mode : List.of(RenderMode.SHADED, RenderMode.OBJECTS, RenderMode.UV)) {
                RenderOptions options = RenderOptions.of(scene).withMode(mode);
                assertThat(Scenes.difference(picture(ready, options), picture(fresh, options), 0)).as(mode.name()).isZero();
            }
            for (int x = 0; x < 33; x += 4) {
                assertThat(ready.explain(x, 14)).isEqualTo(fresh.explain(x, 14));
                assertThat(RenderScene.Pick.at(ready, scene.settings(), x, 14)).isEqualTo(RenderScene.Pick.at(fresh, scene.settings(), x, 14));
            }
        }
        World world = ready.world();
        assertThat(world.later()).hasSize(3);
        assertThat(((Copy) world.surface(PLACES + 2)).original()).as("a copy that moves stays one").isSameAs(((Copy) READY.world().surface(2)).original());
        scene = scene.withObjects(scene.objects().subList(0, PLACES - 3));
        ready = ready.changedTo(scene, RenderMonitor.NONE);
        assertThat(ready.world().surface(2)).as("too few are left").isNotInstanceOf(Copy.class);
        assertThat(Scenes.difference(picture(ready, RenderOptions.of(scene)), picture(RenderScene.of(scene), RenderOptions.of(scene)), 0)).isZero();
    }

    @Test
    void copiesThatMoveAreBlurredAlike() {
        assertAlike(blurred(READY), blurred(READY_APART));
    }

    private static Image blurred(RenderScene ready) {
        Scene scene = ready.scene();
        RenderScene exposed = ready.exposed(t -> scene.with(ScenePath.body(3), body -> body.placed(body.placement().withPosition(new Vec3(2 * t - 1, 0, 2))))
                .with(ScenePath.body(5), body -> body.placed(body.placement().withRotation(new Vec3(0, 90 * t, 0)))), RenderMonitor.NONE);
        return picture(exposed, RenderOptions.of(scene).withSettings(scene.settings().withSamples(3)));
    }

    /** What nobody sees may differ. */
    @Test
    void namesAndPivotsMakeNoDifference() {
        Scene named = SHARED.withObjects(IntStream.range(0, PLACES + 1).mapToObj(i -> {
            SceneObject object = SHARED.objects().get(i);
            return object.shape() instanceof Csg csg && csg.operation() == Csg.Operation.UNION ? object.withShape(named(csg, i)) : object;
        }).toList());
        RenderScene ready = RenderScene.of(named);
        assertThat(((Copy) ready.world().surface(2)).original()).isSameAs(((Copy) ready.world().surface(3)).original());
        assertThat(Scenes.difference(picture(ready, RenderOptions.of(named)), picture(READY, RenderOptions.of(SHARED)), 0)).isZero();
    }

    private static Csg named(Csg csg, int i) {
        List<Operand> operands = new ArrayList<>(csg.operands());
        Operand first = operands.get(0);
        operands.set(0, new Operand("ball " + i, first.solid(), first.placement(), new Placement.Point(new Vec3(i, 0, 0)), false, first.material()));
        return new Csg(csg.operation(), operands);
    }
}
