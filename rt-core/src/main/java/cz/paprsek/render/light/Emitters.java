package cz.paprsek.render.light;

import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The objects of a scene that shine and can be looked for as lights are, which paths do: they are numbered after the scene's lights. Immutable. */
public final class Emitters {
    /** None at all. */
    public static final Emitters NONE = new Emitters(0, List.of(), new int[0], new int[0]);
    /** In place of a number: paths only find it by chance. */
    public static final int NOT_SOUGHT = -1;

    /** More than these are found by chance, all of them: each that is looked for costs a ray at every hit. */
    private static final int MOST = 64;

    private final int first;
    private final Lamp[] lamps;
    /** The index of the object that each of them is. */
    private final int[] objects;
    /** Of each object which of them it is; empty if there are none. */
    private final int[] numbers;

    private Emitters(int first, List<Lamp> lamps, int[] objects, int[] numbers) {
        this.first = first;
        this.lamps = lamps.toArray(Lamp[]::new);
        this.objects = objects;
        this.numbers = numbers;
    }

    public static Emitters of(Scene scene) {
        List<Lamp> lamps = new ArrayList<>();
        List<Integer> objects = new ArrayList<>();
        int first = scene.lights().size();
        int[] numbers = new int[scene.objects().size()];
        Arrays.fill(numbers, NOT_SOUGHT);
        for (int i = 0; i < numbers.length; i++) {
            SceneObject object = scene.objects().get(i);
            if (object.isSoughtIfItShines() && !object.hidden()) {
                Material material = ScenePath.body(i).material(scene);
                if (material.shines()) {
                    if (lamps.size() == MOST) {
                        return NONE;
                    }
                    numbers[i] = first + lamps.size();
                    objects.add(i);
                    lamps.add(lamp(object, material));
                }
            }
        }
        return lamps.isEmpty() ? NONE : new Emitters(first, lamps, objects.stream().mapToInt(i -> i).toArray(), numbers);
    }

    private static Lamp lamp(SceneObject object, Material material) {
        Rgb color = material.emission();
        double strength = material.emissionStrength();
        Affine toWorld = object.placement().toParent();
        if (object.shape() instanceof Sphere ball) {
            return new BallLamp(color, strength, toWorld.point(Vec3.ZERO), ball.radius() * toWorld.uniformScale());
        } else if (object.shape() instanceof Rectangle sheet) {
            Vec3 middle = new Vec3((sheet.minX() + sheet.maxX()) / 2, (sheet.minY() + sheet.maxY()) / 2, 0);
            return new RectangleLamp(color, strength, toWorld.point(middle), toWorld.direction(new Vec3((sheet.maxX() - sheet.minX()) / 2, 0, 0)),
                    toWorld.direction(new Vec3(0, (sheet.maxY() - sheet.minY()) / 2, 0)));
        } else if (object.shape() instanceof Disc disc) {
            return new DiscLamp(color, strength, toWorld.point(Vec3.ZERO), toWorld.direction(new Vec3(disc.radius(), 0, 0)), toWorld.direction(new Vec3(0, disc.radius(), 0)));
        }
        return new BlockLamp(color, strength, (Block) object.shape(), toWorld);
    }

    /** All that is looked for: the scene's lights, these, and a sky. */
    public Lamp[] after(Lamp[] lights, Optional<? extends Lamp> sky) {
        if (lamps.length == 0 && sky.isEmpty()) {
            return lights;
        }
        return Stream.of(Arrays.stream(lights), Arrays.stream(lamps), sky.stream()).flatMap(some -> some).toArray(Lamp[]::new);
    }

    /** The number of an object, or {@link #NOT_SOUGHT}. */
    public int of(int object) {
        return object < numbers.length ? numbers[object] : NOT_SOUGHT;
    }

    /** Whether a number is that of one of these. */
    public boolean has(int number) {
        return number >= first && number < first + lamps.length;
    }

    /** The index in the scene of the object that has a number. */
    public int object(int number) {
        return objects[number - first];
    }
}
