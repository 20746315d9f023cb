package cz.paprsek.cli.bench;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Ellipsoid;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Random scenes that POV-Ray can show exactly: of its size, bodies apart from each other, no light lost in total reflection, nothing
 * transparent that does not bend light. Twelve bodies of any shape and material, CSG among them, on a board.
 */
final class CrossCheckScenes {
    private final Random random;

    private CrossCheckScenes(long seed) {
        random = new Random(seed);
    }

    static Scene random(long seed) {
        return new CrossCheckScenes(seed).scene();
    }

    private Scene scene() {
        List<SceneObject> objects = new ArrayList<>();
        objects.add(SceneObject.of(new Rectangle(-12, -12, 12, 12)).rotated(-90, 0, 0).at(0, -1.6, 0).madeOf(
                Material.DEFAULT.withDiffusion(0.7).withReflection(random.nextInt(2) * 0.2)
                        .withPattern(new Pattern.Checkerboard(15, 13, color(), color()))));
        for (int cell = 0; cell < 12; cell++) {
            // Each body within a ball of radius 1 about the middle of its own cell of 2.2.
            objects.add(body().placed(Placement.at(2.2 * (cell % 4) - 3.3, 2.2 * (cell / 4 % 3) - 0.4, random.nextDouble() * 3 - 2)
                    .withRotation(turn())));
        }
        Vec3 eye = new Vec3(between(-4, 4), between(0, 5), between(8, 11));
        Lens lens = lens();
        boolean isBlurred = lens instanceof Lens.Perspective thin && thin.aperture() > 0;
        // Several pinholes make a lens, a single one does for all others.
        Scene scene = Scene.EMPTY.withSettings(new RenderSettings(64, 48, 6, isBlurred ? 2 : 1))
                .withCamera(Camera.lookingAt(eye, new Vec3(between(-1, 1), 1.5, 0)).withLens(lens).withUp(new Vec3(between(-0.3, 0.3), 1, 0)))
                .withBackground(isBlurred ? dim(color()) : color()).withAmbient(Rgb.ofLinear(between(0, 0.1), between(0, 0.1), between(0, 0.1)))
                .withObjects(objects);
        for (int i = 1 + random.nextInt(3); i > 0; i--) {
            Light light = light().withIntensity(between(0.2, 0.5)).withColor(color());
            scene = scene.plus(isBlurred ? dim(light) : light);
        }
        return scene;
    }

    /** A picture of POV-Ray's is cut off at white, and the mean of such pictures is no mean of light: under it, all is as it should be. */
    private static Rgb dim(Rgb color) {
        return Rgb.ofLinear(0.3 * color.linearRed(), 0.3 * color.linearGreen(), 0.3 * color.linearBlue());
    }

    private static Light dim(Light light) {
        Light dim = light.withIntensity(0.3 * light.intensity());
        return dim instanceof AreaLight area ? area.withVisible(false) : dim instanceof SunLight sun ? sun.withDisc(sun.angle(), false) : dim;
    }

    /** Of any kind but a ball, which POV-Ray cannot be given, above and before the bodies. */
    private Light light() {
        Vec3 place = new Vec3(between(-8, 8), between(6, 9), between(2, 9));
        Vec3 target = new Vec3(between(-2, 2), between(0, 2), 0);
        return switch (random.nextInt(7)) {
            case 0 -> Light.at(place.x(), place.y(), place.z()).withReferenceDistance(between(5, 9));
            case 1 -> SpotLight.from(place, target).withAngles(between(5, 20), between(20, 40));
            case 2 -> SunLight.along(-place.x(), -place.y(), -place.z());
            case 3 -> SunLight.along(-place.x(), -place.y(), -place.z()).withDisc(between(2, 15), random.nextBoolean());
            case 4 -> AreaLight.rectangle(place, between(0.5, 2), between(0.5, 2)).withRotation(new Vec3(between(70, 110), between(-30, 30), between(-30, 30)))
                    .withReferenceDistance(between(6, 9)).withSamples(1 + random.nextInt(16)).withVisible(random.nextBoolean());
            case 5 -> AreaLight.disc(place, between(0.3, 1)).withRotation(new Vec3(between(70, 110), between(-30, 30), between(-30, 30)))
                    .withReferenceDistance(between(6, 9)).withSamples(1 + random.nextInt(16)).withVisible(random.nextBoolean());
            default -> Light.at(place.x(), place.y(), place.z());
        };
    }

    private Lens lens() {
        return switch (random.nextInt(6)) {
            case 0 -> new Lens.Orthographic(between(6, 11));
            case 1 -> new Lens.Spherical();
            case 2 -> new Lens.Fisheye(between(60, 360));
            case 3 -> new Lens.Perspective(between(25, 50), between(0.05, 0.4), random.nextBoolean() ? 0 : between(6, 12));
            default -> Lens.Perspective.DEFAULT.withFovy(between(25, 50));
        };
    }

    private SceneObject body() {
        Shape shape = random.nextInt(6) == 0 ? flat() : random.nextInt(3) == 0 ? tree(2) : solid();
        Material material = material();
        boolean isFlat = !(shape instanceof Solid);
        return SceneObject.of(shape).madeOf(isFlat ? material.withTransparency(0, 1) : material);
    }

    private Shape flat() {
        return random.nextBoolean() ? new Disc(between(0.3, 1)) : new Rectangle(-between(0.2, 0.7), -between(0.2, 0.7), between(0.2, 0.7), between(0.2, 0.7));
    }

    private Solid solid() {
        return switch (random.nextInt(6)) {
            case 0 -> new Sphere(between(0.4, 1));
            case 1 -> new Block(new Vec3(-between(0.2, 0.5), -between(0.2, 0.5), -between(0.2, 0.5)), new Vec3(between(0.2, 0.5), between(0.2, 0.5), between(0.2, 0.5)));
            case 2 -> new Ellipsoid(new Vec3(between(0.2, 1), between(0.2, 1), between(0.2, 1)));
            case 3 -> new Cylinder(between(0.2, 0.5), between(0.4, 0.8));
            case 4 -> new Cone(between(0.2, 0.5), random.nextInt(2) * between(0.1, 0.5), between(0.4, 0.8));
            default -> new Torus(between(0.4, 0.7), between(0.1, 0.3));
        };
    }

    private Csg tree(int levels) {
        Operand[] operands = new Operand[2 + random.nextInt(2)];
        for (int i = 0; i < operands.length; i++) {
            Solid solid = levels > 1 && random.nextInt(3) == 0 ? tree(levels - 1) : solid();
            // An opaque skin now and then: glass within takes the index where light entered, which POV-Ray cannot.
            MaterialSource own = random.nextInt(3) == 0 ? material().withTransparency(0, 1) : Inherited.INHERITED;
            operands[i] = Operand.of(solid).at(between(-0.3, 0.3), between(-0.3, 0.3), between(-0.3, 0.3))
                    .rotated(random.nextInt(360), random.nextInt(360), 0).scaled(between(0.5, 0.8), between(0.5, 0.8), between(0.5, 0.8))
                    .madeOf(own);
        }
        return switch (random.nextInt(3)) {
            case 0 -> Csg.union(operands);
            case 1 -> Csg.difference(operands);
            default -> Csg.intersection(operands);
        };
    }

    private Material material() {
        Material plain = Material.color(color()).withDiffusion(between(0.2, 0.7));
        Material skin = random.nextInt(3) > 0 ? plain : plain.withPattern(pattern());
        return switch (random.nextInt(4)) {
            case 0 -> skin;
            case 1 -> skin.withHighlight(between(0.1, 0.8), random.nextBoolean() ? 1 + random.nextInt(100) : between(1, 100));
            case 2 -> skin.withReflection(between(0.1, 0.6));
            default -> {
                double reflection = between(0, 0.4);
                yield skin.withDiffusion(0.1).withReflection(reflection).withTransparency(1 - reflection, between(1.1, 1.8));
            }
        };
    }

    private Pattern pattern() {
        Pattern.Lay lay = new Pattern.Lay(new Vec3(between(0, 1), between(0, 1), between(0, 1)), turn(), new Vec3(between(0.3, 1), between(0.3, 1), -between(0.3, 1)));
        Pattern.Colors two = new Pattern.TwoColors(color(), color());
        Pattern.Colors several = Pattern.Stops.of(new Pattern.Stop(0.1, color()), new Pattern.Stop(between(0.2, 0.8), color()), new Pattern.Stop(0.9, color()));
        int seed = random.nextInt(1000);
        return switch (random.nextInt(8)) {
            case 0 -> new Pattern.Checker(between(0.2, 0.5), new Vec3(between(0, 0.2), between(0, 0.2), between(0, 0.2)), color(), color());
            case 1 -> new Pattern.Gradient(several, lay);
            case 2 -> new Pattern.Stripes(between(0.1, 0.5), color(), color(), lay);
            case 3 -> new Pattern.Brick(new Vec3(between(0.3, 1), between(0.3, 1), between(0.3, 1)), 0.1, color(), color(), lay);
            case 4 -> new Pattern.Marble(between(1, 3), between(0, 2), 3, seed, several, lay);
            case 5 -> new Pattern.Wood(between(1, 3), between(0, 1), 2, seed, two, lay);
            case 6 -> new Pattern.Granite(4, seed, two, lay);
            default -> new Pattern.Noise(3, seed, several, lay);
        };
    }

    private Vec3 turn() {
        return new Vec3(random.nextInt(360), random.nextInt(360), random.nextInt(360));
    }

    private Rgb color() {
        return Rgb.ofLinear(between(0.05, 1), between(0.05, 1), between(0.05, 1));
    }

    private double between(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }
}
