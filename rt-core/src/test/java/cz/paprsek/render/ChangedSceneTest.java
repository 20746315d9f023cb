package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Sphere;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A scene prepared by what has changed since another one was, has the pictures of one that is prepared anew. */
class ChangedSceneTest {
    private static final int BODIES = 96;
    private static final Material GLASS = Material.color(240, 250, 255).withDiffusion(0.1).withTransparency(0.9, 1.4);

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void afterRandomChangesAllPicturesAreThoseOfAFreshOne(long seed) {
        Random random = new Random(seed);
        Scene scene = Scenes.random(seed, BODIES);
        RenderScene first = RenderScene.of(scene);
        RenderScene ready = first;
        int shared = 0;
        for (int step = 0; step < 12; step++) {
            for (int i = random.nextInt(3); i >= 0; i--) {
                scene = changed(scene, random);
            }
            scene = step % 5 == 4 ? scene.withCamera(Camera.lookingAt(random(random, 4), Vec3.ZERO)) : scene;
            ready = ready.changedTo(scene, RenderMonitor.NONE);
            assertSame(ready, RenderScene.of(scene));
            shared += ready.world().later().findAny().isPresent() ? 1 : 0;
            scene = step % 4 == 3 ? backToFew(scene, first.scene()) : scene;
        }
        assertThat(shared).isGreaterThan(5);
    }

    /** So that there are never too many changes. */
    private static Scene backToFew(Scene scene, Scene first) {
        List<SceneObject> objects = IntStream.range(0, first.objects().size())
                .mapToObj(i -> i % 30 == 0 && i < scene.objects().size() ? scene.objects().get(i) : first.objects().get(i)).toList();
        return scene.withObjects(objects);
    }

    private static Scene changed(Scene scene, Random random) {
        List<SceneObject> objects = new ArrayList<>(scene.objects());
        int at = random.nextInt(objects.size());
        switch (random.nextInt(10)) {
            case 0 -> objects.remove(at);
            case 1 -> objects.add(at, fresh(random));
            case 2 -> objects.add(fresh(random));
            // Two in one place.
            case 4, 5 -> objects.add(at, objects.get(random.nextInt(objects.size())).named("").madeOf(random.nextBoolean() ? GLASS : Scenes.matte(random.nextDouble(), 0.9)));
            case 3 -> objects.add(objects.remove(at));
            default -> {
                return withOneChanged(scene, random);
            }
        }
        return scene.withObjects(objects);
    }

    private static SceneObject fresh(Random random) {
        Vec3 at = random(random, 3);
        return SceneObject.of(random.nextBoolean() ? new Sphere(0.6) : Csg.union(new Sphere(0.6), new Block(Vec3.ZERO, Vec3.ONE)))
                .at(at.x(), at.y(), at.z()).madeOf(random.nextBoolean() ? GLASS : Scenes.matte(random.nextDouble(), 0.9));
    }

    private static Scene withOneChanged(Scene scene, Random random) {
        int object = random.nextInt(10) == 0 ? 0 : random.nextInt(scene.objects().size());
        int other = random.nextInt(scene.objects().size());
        return scene.with(ScenePath.body(object), body -> switch (random.nextInt(7)) {
            case 0 -> body.placed(body.placement().withPosition(random(random, 3)));
            case 1 -> body.placed(body.placement().withRotation(random(random, 180)));
            case 2 -> body.placed(body.placement().withScale(new Vec3(0.5, 0.5 + random.nextDouble(), 1)));
            case 3 -> body.madeOf(GLASS);
            case 4 -> body.madeOf(Scenes.matte(random.nextDouble(), 0.9));
            case 5 -> body.shape() instanceof Csg ? body : body.withShape(random.nextInt(4) == 0 ? new Plane() : new Block(new Vec3(-0.4, -0.4, -0.4), Vec3.ONE));
            // Two in one place: what is met first must not depend on which tree it is in.
            default -> body.shape() instanceof Csg ? body : inTheSamePlace(body, scene.objects().get(other));
        });
    }

    private static Body inTheSamePlace(Body body, SceneObject other) {
        return other.shape() instanceof Csg ? body : body.withShape(other.shape()).placed(other.placement());
    }

    private static Vec3 random(Random random, double reach) {
        return new Vec3(random.nextDouble() * 2 * reach - reach, random.nextDouble() * 2 * reach - reach, random.nextDouble() * 2 * reach - reach);
    }

    private static void assertSame(RenderScene changed, RenderScene fresh) {
        RenderOptions options = RenderOptions.of(fresh.scene());
        Stream.of(RenderMode.SHADED, RenderMode.OBJECTS, RenderMode.NORMALS, RenderMode.DEPTH, RenderMode.SHADOWS, RenderMode.UV).forEach(mode -> {
            Image expected = Renderer.render(fresh, options.withMode(mode), RenderMonitor.NONE).image();
            Image actual = Renderer.render(changed, options.withMode(mode), RenderMonitor.NONE).image();
            assertThat(Scenes.difference(actual, expected, 0)).as(mode.name()).isZero();
        });
        for (int i = 0; i < 33; i += 4) {
            assertThat(changed.explain(i, i % 25)).isEqualTo(fresh.explain(i, i % 25));
            assertThat(RenderScene.Pick.at(changed, fresh.scene().settings(), i, 12)).isEqualTo(RenderScene.Pick.at(fresh, fresh.scene().settings(), i, 12));
        }
    }

    @Test
    void whatHasNotChangedIsTakenOver() {
        Scene scene = Scenes.random(7, BODIES);
        RenderScene ready = RenderScene.of(scene);
        Scene moved = scene.with(ScenePath.body(40), body -> body.placed(body.placement().withPosition(Vec3.ONE)));
        RenderScene changed = ready.changedTo(moved, RenderMonitor.NONE);
        assertThat(changed.world().later()).containsExactly(40);
        assertThat(changed.changedTo(scene, RenderMonitor.NONE).world().bodies()).isSameAs(ready.world().bodies());
    }

    @Test
    void severalChangesOneAfterTheOtherAddUp() {
        Scene scene = Scenes.random(8, BODIES);
        RenderScene ready = RenderScene.of(scene);
        RenderScene changed = ready;
        for (int i = 1; i <= 6; i++) {
            scene = scene.with(ScenePath.body(10 * i), body -> body.placed(body.placement().withPosition(new Vec3(0, 0, -1))));
            changed = changed.changedTo(scene, RenderMonitor.NONE);
        }
        assertThat(changed.world().later()).containsExactly(10, 20, 30, 40, 50, 60);
        assertSame(changed, RenderScene.of(scene));
    }

    @Test
    void ifASixteenthHasChangedAllArePreparedAnew() {
        Scene scene = Scenes.random(9, BODIES);
        RenderScene ready = RenderScene.of(scene);
        Scene moved = scene.with(IntStream.range(0, 7).mapToObj(ScenePath::body).toList(), (at, body) -> body.placed(body.placement().withPosition(Vec3.ONE)));
        RenderScene changed = ready.changedTo(moved, RenderMonitor.NONE);
        assertThat(changed.world().later()).isEmpty();
        assertThat(IntStream.rangeClosed(0, BODIES)).noneMatch(i -> changed.world().surface(i) == ready.world().surface(i));
        assertSame(changed, RenderScene.of(moved));
    }

    @Test
    void anObjectThatGetsOtherPartsOrIsAddedOrTakenAwayIsSeen() {
        Scene scene = Scenes.random(10, BODIES);
        RenderScene ready = RenderScene.of(scene);
        Scene carved = scene.with(ScenePath.body(5), body -> body.withShape(Csg.difference(new Sphere(1), new Sphere(0.7), new Sphere(0.2))));
        Scene plain = scene.with(IntStream.rangeClosed(0, BODIES).filter(i -> scene.objects().get(i).shape() instanceof Csg).limit(1).mapToObj(ScenePath::body).toList(),
                (at, body) -> body.withShape(new Sphere(1)));
        List<SceneObject> reversed = new ArrayList<>(scene.objects());
        Collections.reverse(reversed);
        for (Scene other : List.of(carved, plain, inserted(scene, 0), inserted(scene, 50), scene.plus(SceneObject.of(new Sphere(2)).at(0, 0, -2)),
                scene.withObjects(scene.objects().subList(0, 50)), scene.withObjects(reversed), scene.withObjects(List.of()))) {
            assertSame(ready.changedTo(other, RenderMonitor.NONE), RenderScene.of(other));
        }
    }

    private static Scene inserted(Scene scene, int index) {
        List<SceneObject> objects = new ArrayList<>(scene.objects());
        objects.add(index, SceneObject.of(new Sphere(2)).at(0, 0, -2));
        return scene.withObjects(objects);
    }

    @Test
    void whatIsAddedOrRemovedOrTurnsToGlassTakesOnlyItsOwn() {
        Scene scene = Scenes.random(12, BODIES);
        RenderScene ready = RenderScene.of(scene);
        Scene more = scene.plus(SceneObject.of(new Sphere(1)).at(0, 1, 0), SceneObject.of(new Sphere(1)).at(1, 1, 0).madeOf(GLASS));
        Scene fewer = more.withObjects(more.objects().stream().filter(object -> !object.equals(scene.objects().get(10))).toList());
        Scene glass = fewer.with(List.of(ScenePath.body(3), ScenePath.body(20)), (at, body) -> body.madeOf(GLASS));
        Scene opaque = scene.with(IntStream.rangeClosed(0, BODIES).filter(i -> isGlass(scene, i)).limit(4).mapToObj(ScenePath::body).toList(), (at, body) -> body.madeOf(Scenes.matte(0.4, 0.5)));
        assertSame(ready.changedTo(more, RenderMonitor.NONE), RenderScene.of(more), BODIES + 1, BODIES + 2);
        assertSame(ready.changedTo(fewer, RenderMonitor.NONE), RenderScene.of(fewer), BODIES, BODIES + 1);
        assertSame(ready.changedTo(glass, RenderMonitor.NONE), RenderScene.of(glass), 3, 20, BODIES, BODIES + 1);
        assertSame(ready.changedTo(opaque, RenderMonitor.NONE), RenderScene.of(opaque), opaque.objectsOtherThanIn(scene));
        assertThat(opaque.objectsOtherThanIn(scene)).hasSize(4);
    }

    private static boolean isGlass(Scene scene, int object) {
        return ScenePath.body(object).material(scene).transparency() > 0;
    }

    private static void assertSame(RenderScene changed, RenderScene fresh, int... later) {
        assertThat(changed.world().later()).containsExactly(Arrays.stream(later).boxed().toArray(Integer[]::new));
        assertSame(changed, fresh);
    }

    @Test
    void aNamedMaterialThatChangesIsSeenAndOneMoreTakesNothing() {
        Scene scene = Scenes.random(11, BODIES).plus("paint", GLASS).plus(SceneObject.of(new Sphere(1.5)).madeOf("paint"));
        RenderScene ready = RenderScene.of(scene);
        Scene painted = scene.plus("paint", Scenes.matte(0.7, 0.8));
        assertSame(ready.changedTo(painted, RenderMonitor.NONE), RenderScene.of(painted));
        Scene tinted = scene.plus("paint", GLASS.withTransparency(0.5, 1.7));
        RenderScene again = ready.changedTo(tinted, RenderMonitor.NONE);
        assertThat(again.world().later()).containsExactly(BODIES + 1);
        assertSame(again, RenderScene.of(tinted));
        assertSame(again.changedTo(painted, RenderMonitor.NONE), RenderScene.of(painted));
        Scene more = scene.plus("other", GLASS);
        assertThat(ready.changedTo(more, RenderMonitor.NONE).world().bodies()).isSameAs(ready.world().bodies());
        Scene given = more.with(ScenePath.body(3), body -> body.madeOf(new MaterialName("other")));
        assertSame(ready.changedTo(given, RenderMonitor.NONE), RenderScene.of(given));
    }

    /** As where one of the editor's ready materials is changed, which makes it the scene's own, and where that is undone. */
    @Test
    void aReadyMaterialThatTheSceneGetsAsItsOwnIsSeen() {
        Scene scene = Scenes.random(11, BODIES).plus(SceneObject.of(new Sphere(1.5)).madeOf("gold"));
        RenderScene ready = RenderScene.of(scene);
        Scene own = scene.plus("gold", GLASS);
        RenderScene changed = ready.changedTo(own, RenderMonitor.NONE);
        assertThat(changed.world().later()).containsExactly(BODIES + 1);
        assertSame(changed, RenderScene.of(own));
        assertSame(changed.changedTo(scene, RenderMonitor.NONE), ready);
        assertSame(RenderScene.of(own).changedTo(scene, RenderMonitor.NONE), ready);
    }
}
