package cz.paprsek.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Only what is new in a scene is checked; that must refuse what checking all would. */
class ScenesAreCheckedTest {
    private static final Material BOARD = Material.DEFAULT.withPattern(new Pattern.Checkerboard(2, 2, Rgb.WHITE, Rgb.BLACK));
    private static final int MANY = 700;

    private static SceneObject random(Random random) {
        MaterialSource source = switch (random.nextInt(40)) {
            case 0 -> new MaterialName("tile");
            case 1 -> new MaterialName("gold");
            case 2 -> BOARD;
            default -> Inherited.INHERITED;
        };
        Shape shape = switch (random.nextInt(3)) {
            case 0 -> new Rectangle(-1, -1, 1, 1);
            case 1 -> Csg.union(Operand.of(new Sphere(1)).named(random.nextInt(20) == 0 ? "b" : "a"), Operand.of(new Sphere(2)).named("b"));
            default -> new Sphere(1);
        };
        return new SceneObject(random.nextInt(3) == 0 ? "n" + random.nextInt(5000) : "", shape, Placement.NONE, source);
    }

    private static Map<String, Material> materials(Random random) {
        Map<String, Material> materials = new LinkedHashMap<>();
        materials.put("gold", random.nextInt(4) == 0 ? BOARD : Material.DEFAULT);
        if (random.nextInt(4) > 0) {
            materials.put("tile", random.nextInt(4) == 0 ? BOARD : Material.DEFAULT);
        }
        return materials;
    }

    /** What a scene made anew of the same parts says, or nothing. */
    private static String refusal(Supplier<Scene> scene) {
        try {
            Objects.requireNonNull(scene.get());
            return "";
        } catch (IllegalArgumentException refused) {
            return String.valueOf(refused.getMessage());
        }
    }

    private static Scene anew(Scene scene, Map<String, Material> materials, List<SceneObject> objects) {
        return new Scene(scene.name(), scene.description(), scene.tags(), scene.settings(), scene.background(), scene.sky(), scene.ambient(),
                new ArrayList<>(scene.cameras()), new ArrayList<>(scene.lights()), new LinkedHashMap<>(materials), new ArrayList<>(objects));
    }

    @Test
    void inRandomChangesTheSameIsRefusedAsInScenesMadeAnew() {
        Random random = new Random(14);
        int refused = 0;
        int accepted = 0;
        for (int round = 0; round < 30; round++) {
            Scene scene = Scene.EMPTY.withMaterials(Map.of("gold", Material.DEFAULT, "tile", Material.DEFAULT));
            for (int step = 0; step < 60; step++) {
                Scene before = scene;
                List<SceneObject> objects = new ArrayList<>(before.objects());
                Map<String, Material> materials = random.nextInt(4) == 0 ? materials(random) : before.materials();
                for (int i = random.nextInt(6); i > 0 && materials == before.materials(); i--) {
                    int at = objects.isEmpty() ? 0 : random.nextInt(objects.size());
                    if (objects.isEmpty() || random.nextInt(3) == 0) {
                        objects.add(at, random(random));
                    } else if (random.nextInt(4) == 0) {
                        objects.remove(at);
                    } else {
                        objects.set(at, random(random));
                    }
                }
                Supplier<Scene> change = materials == before.materials() ? () -> before.withObjects(objects) : () -> before.withMaterials(materials);
                String refusal = refusal(change);
                assertThat(refusal.isEmpty()).as(refusal).isEqualTo(refusal(() -> anew(before, materials, objects)).isEmpty());
                scene = refusal.isEmpty() ? change.get() : scene;
                assertThat(scene).isEqualTo(anew(scene, scene.materials(), scene.objects())).hasSameHashCodeAs(anew(scene, scene.materials(), scene.objects()));
                refused += refusal.isEmpty() ? 0 : 1;
                accepted += refusal.isEmpty() ? 1 : 0;
            }
        }
        assertThat(refused).isGreaterThan(100);
        assertThat(accepted).isGreaterThan(500);
    }

    private static Scene many() {
        return Scene.EMPTY.withObjects(IntStream.range(0, MANY).mapToObj(i -> SceneObject.of(new Sphere(1)).named("ball " + i)).toList());
    }

    @Test
    void oneThatIsChangedLeavesAllOthersTheVerySame() {
        Scene scene = many();
        Scene changed = scene.with(ScenePath.body(300), body -> body.placed(body.placement().withPosition(Vec3.ONE)));
        assertThat(changed.objectsOtherThanIn(scene)).containsExactly(300);
        assertThat(scene.objectsOtherThanIn(changed)).containsExactly(300);
        assertThat(changed).isNotEqualTo(scene);
        Scene back = changed.with(ScenePath.body(300), body -> body.placed(scene.objects().get(300).placement()));
        assertThat(back).isEqualTo(scene);
        assertThat(back.objectsOtherThanIn(scene)).containsExactly(300);
    }

    @Test
    void whatIsBeyondTheEndOfTheOtherIsOtherToo() {
        Scene scene = many();
        Scene fewer = scene.withObjects(scene.objects().subList(0, MANY - 3));
        assertThat(fewer.objectsOtherThanIn(scene)).isEmpty();
        assertThat(scene.objectsOtherThanIn(fewer)).containsExactly(MANY - 3, MANY - 2, MANY - 1);
        assertThat(scene.objectsOtherThanIn(Scene.EMPTY)).hasSize(MANY);
    }

    @Test
    void namesAreLookedAtAgainWhereOneIsNew() {
        Scene scene = many();
        assertThatThrownBy(() -> scene.with(ScenePath.body(3), body -> body.named("ball 699"))).hasMessageContaining("already an object named \"ball 699\"");
        assertThatThrownBy(() -> scene.plus(SceneObject.of(new Sphere(1)).named("ball 0"))).hasMessageContaining("already an object named \"ball 0\"");
        assertThat(scene.with(List.of(ScenePath.body(3), ScenePath.body(4)), (at, body) -> body.named("ball " + (7 - at.index()))).objects())
                .extracting(SceneObject::name).startsWith("ball 0", "ball 1", "ball 2", "ball 4", "ball 3");
    }

    private static Solid nested(int levels) {
        Solid nest = new Sphere(1);
        for (int i = 0; i < levels; i++) {
            nest = Csg.union(nest);
        }
        return nest;
    }

    @Test
    void operationsAreNestedAsDeepAsInFilesAndNoDeeper() {
        Scene deepest = Scene.EMPTY.plus(SceneObject.of(nested(250)));
        assertThat(deepest.objects()).hasSize(1);
        assertThat(Scene.EMPTY.plus(SceneObject.of(nested(250))).equals(deepest)).isTrue();
        for (int levels : new int[] {251, 2000, 20_000}) {
            Solid nest = nested(levels);
            assertThatThrownBy(() -> Scene.EMPTY.plus(SceneObject.of(nest))).isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("the operations of this object are nested deeper than the 250 levels that they may be");
        }
        Solid shared = nested(200);
        Solid around = Csg.union(Csg.union(shared), shared, Csg.union(Csg.union(shared)));
        assertThat(Scene.EMPTY.plus(SceneObject.of(around)).objects()).hasSize(1);
        List<String> broken = new ArrayList<>();
        Solid tooDeep = nested(10);
        Solid within = tooDeep;
        for (int i = 0; i < 245; i++) {
            within = Csg.union(within);
        }
        SceneRules.check(List.of(), Map.of(), List.of(SceneObject.of(within), SceneObject.of(tooDeep)), (culprit, attribute, sentence) -> broken.add(sentence));
        assertThat(broken).hasSize(1).allMatch(sentence -> sentence.contains("deeper"));
    }

    @Test
    void listsOfASceneCannotBeChanged() {
        Scene scene = many();
        List<SceneObject> given = new ArrayList<>(scene.objects());
        Scene copy = scene.withObjects(given);
        given.clear();
        assertThat(copy.objects()).hasSize(MANY);
        assertThatThrownBy(() -> scene.objects().set(0, SceneObject.of(new Sphere(1)))).isInstanceOf(UnsupportedOperationException.class);
        assertThatThrownBy(() -> scene.materials().put("x", BOARD)).isInstanceOf(UnsupportedOperationException.class);
        assertThatThrownBy(() -> scene.materials().keySet().clear()).isInstanceOf(UnsupportedOperationException.class);
        assertThatThrownBy(() -> scene.objects().get(MANY)).isInstanceOf(IndexOutOfBoundsException.class);
    }

    /** In code, a few lines make one that nobody could walk through. */
    @ParameterizedTest
    @ValueSource(ints = {27, 28, 62, 64, 500})
    @Timeout(5)
    void aNestOfTooManyIsRefusedBeforeItIsWalkedThrough(int times) {
        SceneObject nest = SceneObject.of(doubled(times, 1, Vec3.ONE)).named("nest");
        assertThatThrownBy(() -> Scene.EMPTY.plus(nest)).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("the scene has more than 134216704 primitives in all places together");
        assertThatThrownBy(() -> many().with(ScenePath.body(3), body -> body.withShape(nest.shape()))).hasMessageStartingWith("the scene has more than");
        List<Object> culprits = new ArrayList<>();
        SceneRules.check(List.of(), Map.of(), List.of(nest), (culprit, attribute, sentence) -> culprits.add(culprit));
        assertThat(culprits).containsExactly(nest);
    }

    @Test
    @Timeout(5)
    void whatStandsOftenInANestIsLookedAtOnce() {
        assertThat(Scene.EMPTY.plus(SceneObject.of(doubled(26, 1, Vec3.ONE))).objects()).hasSize(1);
        Operand wrong = Operand.of(new Sphere(1)).madeOf(new MaterialName("nothing"));
        List<Object> culprits = new ArrayList<>();
        SceneRules.check(List.of(), Map.of(), List.of(SceneObject.of(doubled(20, 1, Vec3.ONE, wrong))), (culprit, attribute, sentence) -> culprits.add(culprit));
        assertThat(culprits).containsOnly(wrong).hasSizeLessThan(3);
    }

    private static Csg doubled(int times, double away, Vec3 scale) {
        return doubled(times, away, scale, Operand.of(new Sphere(1)));
    }

    private static Csg doubled(int times, double away, Vec3 scale, Operand first) {
        Csg all = Csg.union(first);
        for (int i = 0; i < times; i++) {
            all = Csg.union(Operand.of(all).scaled(scale.x(), scale.y(), scale.z()), Operand.of(all).at(away, 0, 0));
        }
        return all;
    }

    /** Which is known of most without working out where each stands. */
    @Test
    void placementsWithinOneAnotherAreRefusedAsTheirMapsAre() {
        Random random = new Random(19);
        int refused = 0;
        for (int round = 0; round < 2000; round++) {
            double wild = Math.pow(10, random.nextInt(30));
            Solid solid = new Sphere(1);
            List<Placement> placements = new ArrayList<>();
            int depth = 1 + random.nextInt(6);
            for (int i = 0; i < depth; i++) {
                Placement placement = new Placement(new Vec3(random.nextGaussian() * wild, 1, 0), new Vec3(0, 0, random.nextInt(4) * 30), scale(random, wild));
                placements.add(0, placement);
                solid = new Csg(Csg.Operation.UNION, List.of(Operand.of(new Sphere(1)), Operand.of(solid).placed(placement)));
            }
            Affine toWorld = Affine.IDENTITY;
            boolean isSane = true;
            for (Placement placement : placements) {
                toWorld = isSane ? toWorld.after(placement.toParent()) : toWorld;
                isSane &= toWorld.isSane();
            }
            Solid made = solid;
            String refusal = refusal(() -> Scene.EMPTY.plus(SceneObject.of(made)));
            assertThat(refusal.isEmpty()).as(placements + refusal).isEqualTo(isSane);
            refused += isSane ? 0 : 1;
        }
        assertThat(refused).isBetween(200, 1800);
    }

    private static Vec3 scale(Random random, double wild) {
        double one = Math.pow(wild, random.nextDouble() * 2 - 1);
        return random.nextBoolean() ? new Vec3(one, one, -one) : new Vec3(one, Math.pow(wild, random.nextDouble() * 2 - 1), 1);
    }
}
