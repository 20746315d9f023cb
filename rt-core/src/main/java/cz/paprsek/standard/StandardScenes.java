package cz.paprsek.standard;

import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Angles;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Ellipsoid;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.mesh.Triangles;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Scenes to measure renderers with, the same on every machine: random numbers come from fixed seeds and {@link Random}, whose formula is
 * part of its contract. Those of paths are 256 × 256 pixels, 16 paths each, eight levels deep; all others 1280 × 720 pixels, one ray each, five levels deep.
 */
public final class StandardScenes {
    private static final long SEED = 20_260_101;
    private static final Material MATT = matt(200, 200, 200);
    private static final Material GREY = Material.color(200, 200, 200).withDiffusion(0.7).withHighlight(0.4, 40);

    private StandardScenes() {}

    /** Five bodies of different kinds, all but one partly mirrors, on a checkered floor that mirrors a little; three lights. */
    public static Scene few() {
        return threeLights(empty("few", new Vec3(0, 2.2, 7), new Vec3(0, 0.6, 0)).withObjects(List.of(
                floor(6, 0.15),
                SceneObject.of(new Sphere(1)).at(-1.6, 1, -0.4).madeOf(mirror(new Rgb(200, 210, 220), 0.6)),
                SceneObject.of(new Sphere(0.6)).at(1.1, 0.6, 1.4).madeOf(mirror(new Rgb(220, 90, 60), 0.25)),
                SceneObject.of(new Block(new Vec3(-0.6, 0, -0.6), new Vec3(0.6, 1.4, 0.6))).at(1.9, 0, -1).rotated(0, 35, 0)
                        .madeOf(mirror(new Rgb(90, 140, 220), 0.2)),
                SceneObject.of(new Ellipsoid(new Vec3(0.5, 0.9, 0.5))).at(0, 0.9, -1.4).madeOf(mirror(new Rgb(120, 200, 110), 0.3)),
                SceneObject.of(new Cone(0.5, 0.2, 0.9)).at(-0.4, 0, 1.6).madeOf(GREY))));
    }

    /**
     * A mirroring sphere with nine of a third its size on it, each with nine more, and so on, over a floor; three lights. Level 4 has 7381
     * spheres, level 5 has 66 430.
     *
     * @source Haines, A Proposal for Standard Graphics Environments, IEEE CG&amp;A 7(11), 1987
     */
    public static Scene flake(int levels) {
        Require.within("levels", levels, 0, 7);
        List<SceneObject> objects = new ArrayList<>();
        objects.add(floor(12, 0));
        grow(Vec3.Y, Vec3.Y, 1, levels, mirror(new Rgb(230, 200, 150), 0.5), objects);
        return threeLights(empty("flake" + levels, new Vec3(1.6, 2.6, 4.2), new Vec3(0, 0.8, 0)).withObjects(objects));
    }

    /** Small spheres strewn in a cube, a fiftieth of it full whatever their number; one light. */
    public static Scene cloud(int spheres) {
        Require.within("spheres", spheres, 1, 100_000_000);
        Sphere sphere = new Sphere(StrictMath.cbrt(0.02 * 8 / (spheres * 4.19)));
        Material[] materials = {GREY, Material.color(220, 120, 80).withDiffusion(0.7), Material.color(90, 140, 220).withDiffusion(0.7)};
        Random random = new Random(SEED);
        List<SceneObject> objects = new ArrayList<>(spheres);
        for (int i = 0; i < spheres; i++) {
            objects.add(SceneObject.of(sphere).at(inCube(random), inCube(random), inCube(random)).madeOf(materials[i % materials.length]));
        }
        return empty("cloud" + spheres, new Vec3(1.5, 1.2, 2.6), Vec3.ZERO).plus(Light.at(4, 6, 5)).withObjects(objects);
    }

    /** Blocks with a ball taken out of a corner, strewn and turned at random; three lights. */
    public static Scene carved(int bodies) {
        Require.within("bodies", bodies, 1, 10_000_000);
        Material inside = Material.color(220, 90, 60).withDiffusion(0.8);
        return strewn("csg" + bodies, bodies, Csg.difference(
                Operand.of(cube(0.7)), Operand.of(new Sphere(0.7)).at(0.7, 0.7, 0.7).madeOf(inside)));
    }

    /** Rounded blocks, pierced along all three axes: three operations over five solids, strewn and turned at random; three lights. */
    public static Scene pierced(int bodies) {
        Require.within("bodies", bodies, 1, 10_000_000);
        Material inside = Material.color(90, 140, 220).withDiffusion(0.8);
        Operand tube = Operand.of(new Cylinder(0.4, 2)).at(0, -1, 0);
        Csg tubes = Csg.union(tube, tube.at(1, 0, 0).rotated(0, 0, 90), tube.at(0, 0, -1).rotated(90, 0, 0));
        return strewn("csgn" + bodies, bodies, Csg.difference(
                Operand.of(Csg.intersection(cube(0.7), new Sphere(0.95))), Operand.of(tubes).madeOf(inside)));
    }

    /** A union of spheres in a row, each touching the next: one body; three lights. */
    public static Scene chain(int operands) {
        Require.within("operands", operands, 2, 1_000_000);
        Operand[] spheres = new Operand[operands];
        double radius = 2.0 / operands;
        for (int i = 0; i < operands; i++) {
            spheres[i] = Operand.of(new Sphere(1.5 * radius)).at(-2 + (2 * i + 1) * radius, 0, 0);
        }
        return threeLights(empty("chain" + operands, new Vec3(0, 1, 4), Vec3.ZERO).plus(SceneObject.of(Csg.union(spheres)).madeOf(GREY)));
    }

    /** A ring with waves, of about so many triangles, all of one mesh, over a floor; three lights. */
    public static Scene mesh(int triangles) {
        return threeLights(empty("mesh" + triangles, new Vec3(0, 2.4, 3.6), new Vec3(0, 0.4, 0)).withObjects(List.of(floor(6, 0.15),
                SceneObject.of(Mesh.of(waves(triangles))).madeOf(mirror(new Rgb(200, 170, 120), 0.2)))));
    }

    /** One ring of about so many triangles, strewn and turned at random in many places; three lights. */
    public static Scene instances(int bodies, int triangles) {
        Require.within("bodies", bodies, 1, 10_000_000);
        return strewn("instances" + bodies, bodies, Mesh.of(waves(triangles)));
    }

    /** The ring by itself, matt; one light. */
    public static Scene ring(int triangles) {
        return empty("ring" + triangles, new Vec3(0, 2.4, 3.6), new Vec3(0, 0.4, 0)).plus(Light.at(6, 8, 6)).plus(SceneObject.of(Mesh.of(waves(triangles))).madeOf(MATT));
    }

    /**
     * The box of Cornell, in decimetres, with its two blocks: light that goes from wall to wall. By paths.
     *
     * @source Cornell University Program of Computer Graphics, Cornell Box Data, as in scenes/cornell.xml
     */
    public static Scene box() {
        Material white = matt(241.746, 217.69, 213.147);
        return room("box", white, matt(198.836, 58.496, 59.44), matt(91.336, 165.34, 78.12)).plus(
                SceneObject.of(new Block(new Vec3(-0.825, 0, -0.825), new Vec3(0.825, 1.65, 0.825))).at(1.855, 0, 1.69).rotated(0, -16.8, 0).madeOf(white),
                SceneObject.of(new Block(new Vec3(-0.825, 0, -0.825), new Vec3(0.825, 3.3, 0.825))).at(3.685, 0, 3.5125).rotated(0, 17.3, 0).madeOf(white));
    }

    /** The same room, all of it light and matt, with a ring of about so many triangles in place of the blocks. By paths. */
    public static Scene interior(int triangles) {
        return room("interior" + triangles, MATT, MATT, MATT).plus(
                SceneObject.of(Mesh.of(waves(triangles))).at(2.764, 1.8, 2.8).rotated(-50, 0, 20).scaled(1.6, 1.6, 1.6).madeOf(MATT));
    }

    private static Scene room(String name, Material white, Material left, Material right) {
        return Scene.EMPTY.withName(name).withSettings(new RenderSettings(256, 256, 8, 1).withIntegrator(Integrator.PATH).withSamples(16))
                .withCamera(Camera.lookingAt(new Vec3(2.78, 2.73, -8), new Vec3(2.78, 2.73, 0)).withFovy(39.3077))
                .plus(AreaLight.rectangle(new Vec3(2.78, 5.487, 2.795), 1.3, 1.05).withRotation(new Vec3(90, 0, 0)).withColor(new Rgb(255, 226.025, 163.211)).withIntensity(7.989))
                .withObjects(List.of(
                        SceneObject.of(new Rectangle(0, 0, 5.528, 5.592)).rotated(90, 0, 0).madeOf(white),
                        SceneObject.of(new Rectangle(0, 0, 5.528, 5.592)).at(0, 5.488, 0).rotated(90, 0, 0).madeOf(white),
                        SceneObject.of(new Rectangle(0, 0, 5.528, 5.488)).at(0, 0, 5.592).madeOf(white),
                        SceneObject.of(new Rectangle(0, 0, 5.592, 5.488)).at(5.528, 0, 0).rotated(0, -90, 0).madeOf(left),
                        SceneObject.of(new Rectangle(0, 0, 5.592, 5.488)).rotated(0, -90, 0).madeOf(right)));
    }

    private static Material matt(double red, double green, double blue) {
        return Material.color(red, green, blue).withDiffusion(1);
    }

    private static Triangles waves(int triangles) {
        Require.within("triangles", triangles, 100, 50_000_000);
        int tube = (int) Math.round(Math.sqrt(triangles / 8.0));
        int around = 4 * tube;
        Triangles.Builder out = Triangles.builder().expect(around * tube, 2 * around * tube);
        for (int i = 0; i < around; i++) {
            double a = 2 * Math.PI * i / around;
            for (int j = 0; j < tube; j++) {
                double b = 2 * Math.PI * j / tube;
                double radius = 0.45 + 0.03 * StrictMath.sin(40 * a) * StrictMath.cos(10 * b) + 0.01 * StrictMath.sin(190 * a + 40 * b);
                double rho = 1.2 + radius * StrictMath.cos(b);
                out.vertex(rho * StrictMath.cos(a), 0.6 + radius * StrictMath.sin(b), rho * StrictMath.sin(a));
            }
        }
        for (int i = 0; i < around; i++) {
            int here = i * tube;
            int there = (i + 1) % around * tube;
            for (int j = 0; j < tube; j++) {
                int next = (j + 1) % tube;
                out.triangle(here + j, here + next, there + next);
                out.triangle(here + j, there + next, there + j);
            }
        }
        return out.build();
    }

    private static Scene empty(String name, Vec3 eye, Vec3 target) {
        return Scene.EMPTY.withName(name).withSettings(new RenderSettings(1280, 720, 5, 1))
                .withBackground(new Rgb(40, 60, 90)).withCamera(Camera.lookingAt(eye, target));
    }

    private static Scene threeLights(Scene scene) {
        return scene.withAmbient(Rgb.grey(40)).withLights(List.of(
                Light.at(6, 8, 6).withIntensity(0.5), Light.at(-7, 6, 4).withIntensity(0.3), Light.at(1, 9, -5).withIntensity(0.3)));
    }

    private static SceneObject floor(double half, double reflection) {
        return SceneObject.of(new Rectangle(-half, -half, half, half)).rotated(-90, 0, 0)
                .madeOf(mirror(Rgb.WHITE, reflection).withPattern(new Pattern.Checkerboard(12, 12, Rgb.grey(230), Rgb.grey(70))));
    }

    private static Material mirror(Rgb color, double reflection) {
        return Material.color(color).withDiffusion(0.8 * (1 - reflection)).withHighlight(0.5, 50).withReflection(reflection);
    }

    private static Solid cube(double half) {
        return new Block(new Vec3(-half, -half, -half), new Vec3(half, half, half));
    }

    private static Scene strewn(String name, int bodies, Solid body) {
        double size = StrictMath.cbrt(0.06 * 8 / bodies);
        Random random = new Random(SEED);
        List<SceneObject> objects = new ArrayList<>(bodies);
        for (int i = 0; i < bodies; i++) {
            objects.add(SceneObject.of(body).at(inCube(random), inCube(random), inCube(random))
                    .rotated(random.nextInt(360), random.nextInt(360), random.nextInt(360)).scaled(size, size, size).madeOf(GREY));
        }
        return threeLights(empty(name, new Vec3(1.5, 1.2, 2.6), Vec3.ZERO).withObjects(objects));
    }

    private static double inCube(Random random) {
        return 2 * random.nextDouble() - 1;
    }

    /** Adds a sphere and its children: six around its equator as seen along the axis, three above. */
    private static void grow(Vec3 centre, Vec3 axis, double radius, int levels, Material material, List<SceneObject> objects) {
        objects.add(SceneObject.of(new Sphere(radius)).at(centre.x(), centre.y(), centre.z()).madeOf(material));
        if (levels == 0) {
            return;
        }
        Vec3 side = (Math.abs(axis.x()) < 0.5 ? Vec3.X : Vec3.Z).cross(axis).normalized();
        Vec3 other = axis.cross(side);
        for (int i = 0; i < 9; i++) {
            double angle = i < 6 ? i * 60 : 30 + (i - 6) * 120;
            double height = i < 6 ? 0 : 0.8;
            double width = Math.sqrt(1 - height * height);
            Vec3 around = side.times(Angles.cos(angle)).plus(other.times(Angles.sin(angle)));
            Vec3 direction = around.times(width).plus(axis.times(height));
            grow(centre.plus(direction.times(radius * 4 / 3)), direction, radius / 3, levels - 1, material, objects);
        }
    }
}
