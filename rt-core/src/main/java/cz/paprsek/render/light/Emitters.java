package cz.paprsek.render.light;

import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.mesh.Triangles;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The objects of a scene that shine and can be looked for as lights are, which paths do: they are numbered after the scene's lights. Immutable. */
public final class Emitters {
    /** None at all. */
    public static final Emitters NONE = new Emitters(0, new Gathered(0));
    /** In place of a number: paths only find it by chance. */
    public static final int NOT_SOUGHT = -1;

    /** Of more than these one is chosen: each that is looked for costs a ray at every hit. */
    private static final int MOST_AT_ONCE = 16;
    private static final int[] NOBODY = {};

    private final int first;
    private final Lamp[] lamps;
    /** The index of the object that each of them is, or is a triangle of. */
    private final int[] objects;
    /** Of each object which of them it is; of a mesh, of each triangle; empty of others. */
    private final int[][] numbers;
    private final Optional<LampTree> tree;

    private Emitters(int first, Gathered all) {
        this.first = first;
        lamps = all.lamps.toArray(Lamp[]::new);
        objects = all.objects.stream().mapToInt(i -> i).toArray();
        numbers = all.numbers;
        tree = lamps.length > MOST_AT_ONCE ? Optional.of(new LampTree(all.boxes, all.powers.stream().mapToDouble(power -> power).toArray())) : Optional.empty();
    }

    public static Emitters of(Scene scene) {
        Gathered all = new Gathered(scene.objects().size());
        for (int i = 0; i < scene.objects().size(); i++) {
            SceneObject object = scene.objects().get(i);
            Material material = ScenePath.body(i).material(scene);
            if (object.isSoughtIfItShines() && !object.hidden() && material.shines()) {
                if (object.shape() instanceof Mesh mesh) {
                    all.add(i, mesh.triangles(), material, object.placement().toParent());
                } else {
                    Lamp lamp = lamp(object, material);
                    all.numbers[i] = new int[] {all.add(i, lamp, object.shape().bounds().transformed(object.placement().toParent()), area(object, lamp))};
                }
            }
        }
        return all.lamps.isEmpty() ? NONE : new Emitters(scene.lights().size(), all);
    }

    /** The lamps on their way. */
    private static final class Gathered {
        private final List<Lamp> lamps = new ArrayList<>();
        private final List<Integer> objects = new ArrayList<>();
        private final List<Bounds> boxes = new ArrayList<>();
        private final List<Double> powers = new ArrayList<>();
        private final int[][] numbers;

        Gathered(int objects) {
            numbers = new int[objects][0];
        }

        /** @param area of all sides that shine */
        private int add(int object, Lamp lamp, Bounds box, double area) {
            lamps.add(lamp);
            objects.add(object);
            boxes.add(box);
            powers.add(area * (lamp.red() + lamp.green() + lamp.blue()));
            return lamps.size() - 1;
        }

        private void add(int object, Triangles mesh, Material material, Affine toWorld) {
            numbers[object] = new int[mesh.count()];
            for (int i = 0; i < mesh.count(); i++) {
                Vec3 a = toWorld.point(mesh.place(mesh.corner(i, 0)));
                Vec3 b = toWorld.point(mesh.place(mesh.corner(i, toWorld.mirrors() ? 2 : 1)));
                Vec3 c = toWorld.point(mesh.place(mesh.corner(i, toWorld.mirrors() ? 1 : 2)));
                boolean isSeen = b.minus(a).cross(c.minus(a)).length() > 0;
                numbers[object][i] = isSeen ? add(object, a, b, c, material, mesh.isClosed()) : NOT_SOUGHT;
            }
        }

        private int add(int object, Vec3 a, Vec3 b, Vec3 c, Material material, boolean isClosed) {
            TriangleLamp lamp = new TriangleLamp(material.emission(), material.emissionStrength(), a, b, c, isClosed);
            return add(object, lamp, Bounds.of(a, b).union(Bounds.of(a, c)), lamp.area());
        }
    }

    private static double area(SceneObject object, Lamp lamp) {
        if (lamp instanceof AreaLamp flat) {
            return 2 * flat.area();
        } else if (lamp instanceof BlockLamp block) {
            return block.area();
        }
        double radius = ((Sphere) object.shape()).radius() * object.placement().toParent().uniformScale();
        return 4 * Math.PI * radius * radius;
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

    /** All that is looked for: the scene's lights, these or one that is chosen of them, and a sky. */
    public Lamp[] after(Lamp[] lights, Optional<ManyLamps> chosen, Optional<? extends Lamp> sky) {
        if (lamps.length == 0 && sky.isEmpty()) {
            return lights;
        }
        return Stream.of(Arrays.stream(lights), chosen.isPresent() ? Stream.of(chosen.get()) : Arrays.stream(lamps), sky.stream()).flatMap(some -> some).toArray(Lamp[]::new);
    }

    /** For one worker, what chooses one of these where they are many; else empty. */
    public Optional<ManyLamps> chosen() {
        return tree.map(all -> new ManyLamps(this, all));
    }

    Lamp lamp(int body) {
        return lamps[body];
    }

    /**
     * The number of an object's surface, or {@link #NOT_SOUGHT}.
     *
     * @param face of a mesh the triangle
     */
    public int of(int object, int face) {
        int[] own = object < numbers.length ? numbers[object] : NOBODY;
        int body = own.length == 0 ? NOT_SOUGHT : own.length == 1 ? own[0] : own[face];
        return body == NOT_SOUGHT ? NOT_SOUGHT : first + body;
    }

    /** The number of what comes after all of these. */
    public int end() {
        return first + lamps.length;
    }

    /** Whether a number is that of one of these. */
    public boolean has(int number) {
        return number >= first && number < end();
    }

    /** The index in the scene of the object that has a number. */
    public int object(int number) {
        return objects[number - first];
    }
}
