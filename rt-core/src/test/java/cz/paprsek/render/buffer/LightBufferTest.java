package cz.paprsek.render.buffer;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.light.Lamp;
import cz.paprsek.render.surface.Bodies;
import cz.paprsek.render.surface.World;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** What stands in the way of a light is what the tree finds, whatever and wherever the bodies and the light are. */
class LightBufferTest {
    /** In every build few; the proof is to be had by {@code -Dpaprsek.proof}. */
    private static final int SCENES = System.getProperty("paprsek.proof") == null ? 120 : 3_000;
    private static final int RAYS = 2_000;

    private final Spans spans = new Spans();
    private int made;
    private int blocked;
    private int veiled;

    @Test
    void itFindsWhatTheTreeFinds() {
        for (int seed = 0; seed < SCENES; seed++) {
            Random random = new Random(seed);
            double scale = Math.pow(10, random.nextInt(13) - 6);
            Vec3 offset = vec(random, scale * (random.nextInt(3) == 0 ? 1000 : 1));
            World world = new World(scene(random, scale, offset), new Textures(Assets.none()), () -> false);
            Lamp lamp = world.lamps()[0];
            Optional<LightBuffer> buffer = world.bodies().buffers().orElseThrow().of(lamp.place().orElseThrow(), () -> false);
            if (buffer.isPresent()) {
                made++;
                compare(world, lamp.place().orElseThrow(), buffer.get(), random, scale, offset, seed);
            }
        }
        assertThat(made).as("scenes that have a buffer").isGreaterThan(SCENES / 2);
        assertThat(blocked).isBetween(SCENES * RAYS / 20, SCENES * RAYS * 19 / 20);
        assertThat(veiled).isGreaterThan(SCENES * RAYS / 100);
    }

    private static Scene scene(Random random, double scale, Vec3 offset) {
        Scene scene = Scene.EMPTY;
        boolean isCrowded = random.nextBoolean();
        int bodies = 16 + random.nextInt(isCrowded ? 400 : 30);
        double size = isCrowded ? 0.05 : 0.2;
        for (int i = 0; i < bodies; i++) {
            Material material = random.nextInt(4) == 0 ? Material.DEFAULT.withTransparency(0.5, 1.2) : Material.DEFAULT;
            Shape shape = shape(random, scale * size * Math.pow(2, 3 * random.nextDouble() - 1.5));
            scene = scene.plus(placed(shape, offset.plus(vec(random, scale))).madeOf(material).rotated(random.nextInt(360), random.nextInt(4) * 90, 0));
        }
        if (random.nextBoolean()) {
            scene = scene.plus(placed(new Block(vec(-9, -9, -0.1).times(scale), vec(9, 9, 0.1).times(scale)), offset.plus(vec(0, 0, -1.2 * scale))));
        }
        Vec3 way = vec(random, 1).normalized();
        Vec3 at = offset.plus(way.times(scale * (1.2 + Math.pow(10, 4 * random.nextDouble() - 2))));
        Light light = random.nextInt(3) == 0 ? SunLight.along(way.x(), way.y(), way.z()) : Light.at(at.x(), at.y(), at.z());
        return scene.plus(light);
    }

    private static SceneObject placed(Shape shape, Vec3 at) {
        return SceneObject.of(shape).at(at.x(), at.y(), at.z());
    }

    private static Shape shape(Random random, double size) {
        return switch (random.nextInt(8)) {
            case 0 -> new Block(vec(-size, -size / 4, -size), vec(size, size / 3, size));
            case 1 -> new Cylinder(size / 2, size);
            case 2 -> new Torus(size, size / 4);
            case 3 -> new Disc(size);
            case 4 -> Csg.difference(new Block(vec(-size, -size, -size), vec(size, size, size)), new Sphere(1.2 * size));
            default -> new Sphere(size);
        };
    }

    /** Rays from surfaces, from anywhere among the bodies, and from far away; to be told apart, they begin where an eye's ray ends, too. */
    private void compare(World world, LightPlace light, LightBuffer buffer, Random random, double scale, Vec3 offset, int seed) {
        Bodies bodies = world.bodies();
        Bodies.Finder finder = bodies.newFinder();
        Ray eye = new Ray(spans);
        Ray ray = new Ray(spans);
        for (int i = 0; i < RAYS; i++) {
            Vec3 from = offset.plus(vec(random, scale * (random.nextInt(8) == 0 ? 100 : 1.5)));
            int part = -1;
            boolean inwards = false;
            if (random.nextInt(4) > 0) {
                Vec3 d = vec(random, 1).normalized();
                eye.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
                bodies.nearest(eye, bodies.whole(), finder);
                if (eye.part >= 0) {
                    from = from.plus(d.times(eye.max));
                    part = eye.part;
                    inwards = random.nextInt(4) == 0;
                }
            }
            Vec3 way = light.isFar() ? light.at() : light.at().minus(from);
            double size = Math.abs(from.x()) + Math.abs(from.y()) + Math.abs(from.z()) + scale;
            double end = light.isFar() ? Double.POSITIVE_INFINITY : way.length() - Ray.TOUCH * size;
            Vec3 d = way.normalized();
            ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z(), size, end, part, inwards);
            if (random.nextBoolean()) {
                ray.min = ray.contact;
            }
            if (!buffer.knows(ray)) {
                continue;
            }
            spans.release(0);
            Surface wanted = bodies.occluder(ray, bodies.whole(), finder, spans);
            List<Double> through = through();
            Surface found = bodies.occluder(ray, buffer, spans);
            if (wanted == null) {
                assertThat(found).as("scene %d, ray %d", seed, i).isNull();
                assertThat(through()).as("scene %d, ray %d", seed, i).isEqualTo(through);
                veiled += through.isEmpty() ? 0 : 1;
            } else {
                blocked++;
                assertThat(found != null && found.occludes(ray)).as("scene %d, ray %d", seed, i).isTrue();
            }
            spans.release(0);
        }
    }

    /** Where boundaries are crossed that let light through, in order. */
    private List<Double> through() {
        TreeSet<Double> all = new TreeSet<>();
        for (int i = 0; i < spans.size(); i++) {
            all.add(spans.t(i));
        }
        spans.release(0);
        return List.copyOf(all);
    }

    private static Vec3 vec(double x, double y, double z) {
        return new Vec3(x, y, z);
    }

    private static Vec3 vec(Random random, double most) {
        return new Vec3(2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1).times(most);
    }
}
