package cz.paprsek.xml;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.material.Share;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Animation.Ease;
import cz.paprsek.scene.Animation.Turning;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Examples;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** Scenes with something of everything that a file can hold, numbers of all sizes included. */
public final class RandomScenes {
    private final Random random;

    private RandomScenes(long seed) {
        random = new Random(seed);
    }

    public static Scene of(long seed) {
        return new RandomScenes(seed).scene();
    }

    private Scene scene() {
        Map<String, Material> materials = new LinkedHashMap<>();
        for (int i = 0; i < 4; i++) {
            materials.put("material <" + i + "> & \"more\" ěščř 光", material());
        }
        List<String> names = new ArrayList<>(materials.keySet());
        List<SceneObject> objects = new ArrayList<>();
        int number = 0;
        for (Shape shape : Examples.ALL.values()) {
            MaterialSource source = shape instanceof Solid ? source(names) : boardOr(names);
            objects.add(new SceneObject(number % 2 == 0 ? "" : "object " + number, shape, shape instanceof Csg ? nested() : placement(), pivot(number % 3 == 1), number % 4 == 3, source));
            number++;
        }
        objects.add(SceneObject.of(tree(3, names)));
        Scene bare = new Scene("Scene < & > \" '", random.nextBoolean() ? "" : "Two\nlines, <tags> & all", List.of("one", "two-2"),
                gathering(new RenderSettings(1 + random.nextInt(3000), 1 + random.nextInt(3000), 1 + random.nextInt(20), Integrator.WHITTED, 1 + random.nextInt(5), random.nextInt(2) * (5 + random.nextInt(12)),
                        random.nextInt(3) > 0 ? 0.01 : random.nextDouble() + 1e-9, random.nextInt(3) > 0 ? 0.95 : 0.5 + random.nextDouble() / 3, List.of(PixelFilter.values()).get(random.nextInt(4)),
                        random.nextInt(2) * random.nextDouble(), List.of(Tone.values()).get(random.nextInt(2)),
                        random.nextBoolean() ? 25 : 1000 * (1 - random.nextDouble()), random.nextInt(2) * random.nextDouble())),
                Rgb.BLACK, Sky.NONE, color(), cameras(), lights(),
                materials, objects);
        return under(random.nextBoolean() ? bare : bare.withAnimations(animations()));
    }

    /** Of what no edit takes away. */
    private List<Animation> animations() {
        String target = "camera:side & \"top\"";
        List<Animation.Key> keys = new ArrayList<>();
        for (int i = 0; i <= random.nextInt(4); i++) {
            keys.add(new Animation.Key(i + random.nextDouble(), "-7000 " + number() + " " + random.nextInt(9), pick(Ease.values())));
        }
        return List.of(new Animation(target, "position", Turning.ANGLES, keys), new Animation(target, "up", Turning.ANGLES, List.of(new Animation.Key(-number(), "0 1 0", Ease.LINEAR))));
    }

    private RenderSettings gathering(RenderSettings settings) {
        return switch (random.nextInt(5)) {
            case 0 -> settings.withIntegrator(Integrator.PATH);
            case 1 -> settings.withIntegrator(Integrator.PATH).withSamples(1 + random.nextInt(RenderSettings.MOST_PATHS));
            case 2 -> settings.withIntegrator(Integrator.PATH).withSamples(1 + random.nextInt(64), 64 + random.nextInt(1000));
            default -> settings;
        };
    }

    private Scene under(Scene scene) {
        return switch (random.nextInt(3)) {
            case 0 -> scene.withBackground(color());
            case 1 -> scene.withSky(new Sky.Gradient(color(), color(), color()));
            default -> scene.withSky(new Sky.Picture("skies/\"blue\" & <white>.hdr", random.nextInt(2) * 77.5, number()));
        };
    }

    private List<Camera> cameras() {
        return List.of(camera().withLens(lens()), camera().named("side & \"top\"").withLens(lens()));
    }

    private Lens lens() {
        return switch (random.nextInt(5)) {
            case 0 -> new Lens.Orthographic(number());
            case 1 -> new Lens.Spherical();
            case 2 -> new Lens.Fisheye(random.nextInt(2) * 100 + 180);
            case 3 -> new Lens.Perspective(1 + random.nextInt(150), 0.25, number());
            default -> new Lens.Perspective(1 + random.nextInt(150), 0, random.nextInt(3));
        };
    }

    private List<Light> lights() {
        return List.of(new PointLight("", vector(), color(), number(), 0), Light.at(1, 2, 3).named("key").withReferenceDistance(number()),
                new SpotLight("spot", vector(), random.nextBoolean() ? new Camera.Direction(new Vec3(1, 2, 3)) : new Camera.Target(new Vec3(-5000, 2, 3)),
                        color(), 2, number(), 5 * random.nextDouble(), 5 + 85 * random.nextDouble()),
                new AreaLight("", vector(), vector(), random.nextBoolean() ? new AreaLight.Size(number(), number()) : new AreaLight.Radius(number()),
                        color(), 1, number(), 1 + random.nextInt(99), random.nextBoolean()),
                new SphereLight("ball", vector(), number(), color(), 1, number(), 1 + random.nextInt(99), random.nextBoolean()),
                new SunLight("", new Vec3(1, random.nextDouble(), 0), color(), 3, random.nextBoolean() ? 0 : random.nextInt(180), random.nextBoolean()));
    }

    private Camera camera() {
        Camera.Aim aim = random.nextBoolean() ? new Camera.Direction(new Vec3(random.nextDouble(), 0.3, -1)) : new Camera.Target(vector());
        return new Camera(new Vec3(-5000, 2, 3), aim, new Vec3(0.1, 1, 0), 1 + random.nextInt(150));
    }

    private Solid tree(int levels, List<String> names) {
        Operand[] operands = new Operand[1 + random.nextInt(3)];
        for (int i = 0; i < operands.length; i++) {
            Solid solid = levels == 0 ? new Cone(number(), 1, number()) : tree(levels - 1, names);
            operands[i] = new Operand(i == 0 ? "" : "part " + i, solid, nested(), pivot(i == 1), i == 2, source(names));
        }
        return new Csg(pick(Csg.Operation.UNION, Csg.Operation.DIFFERENCE, Csg.Operation.INTERSECTION), List.of(operands));
    }

    @SafeVarargs
    private <T> T pick(T... from) {
        return from[random.nextInt(from.length)];
    }

    private MaterialSource source(List<String> names) {
        return switch (random.nextInt(3)) {
            case 0 -> Inherited.INHERITED;
            case 1 -> new MaterialName(names.get(random.nextInt(names.size())));
            default -> material();
        };
    }

    private MaterialSource boardOr(List<String> names) {
        return random.nextBoolean() ? source(names) : material().withPattern(
                new Pattern.Checkerboard(1 + random.nextInt(99), 1 + random.nextInt(99), color(), color()));
    }

    private Material material() {
        return new Material(random.nextBoolean() ? new Pattern.Plain(color()) : pattern(), random.nextDouble(), random.nextDouble(), number(), random.nextDouble(), random.nextDouble(),
                1 + random.nextDouble()).withFresnel(pick(Material.Fresnel.values()))
                .withAttenuation(color(), number()).withEmission(color(), number())
                .withRoughness(random.nextDouble()).withThin(random.nextBoolean())
                .withShares(new Material.Shares(share(), share(), share(), share(), share())).withRelief(relief());
    }

    private Share share() {
        return random.nextInt(3) > 0 ? new Share.Even() : new Share.ByPattern(pick(Share.ColorChannel.values()), pattern());
    }

    private Material.Relief relief() {
        return switch (random.nextInt(4)) {
            case 0 -> new Material.Bump(random.nextBoolean() ? 0.02 : number(), pattern());
            case 1 -> new Material.NormalMap("a normal map.png", number(), pick(Pattern.Filter.values()), pick(Pattern.Mapping.values()), lay());
            default -> Material.Relief.FLAT;
        };
    }

    private Pattern pattern() {
        int octaves = 1 + random.nextInt(12);
        int seed = random.nextInt(1_000_001);
        return switch (random.nextInt(10)) {
            case 0 -> new Pattern.Checker(number(), vector(), color(), color());
            case 1 -> new Pattern.Checker(new Vec3(number(), number(), number()), vector(), color(), color(), lay());
            case 2 -> new Pattern.Gradient(colors(), lay());
            case 3 -> new Pattern.Stripes(number(), color(), color(), lay());
            case 4 -> new Pattern.Brick(new Vec3(number(), number(), number()), random.nextInt(2) * number(), color(), color(), lay());
            case 5 -> new Pattern.Marble(number(), random.nextInt(2) * number(), octaves, seed, colors(), lay());
            case 6 -> new Pattern.Wood(number(), random.nextInt(2) * number(), octaves, seed, colors(), lay());
            case 8 -> new Pattern.Picture("a picture.png", pick(Pattern.Filter.values()), pick(Pattern.Mapping.values()), lay());
            case 7 -> new Pattern.Granite(octaves, seed, colors(), lay());
            default -> new Pattern.Noise(octaves, seed, colors(), lay());
        };
    }

    private Pattern.Colors colors() {
        return random.nextBoolean() ? new Pattern.TwoColors(color(), color())
                : Pattern.Stops.of(new Pattern.Stop(random.nextDouble() / 2, color()), new Pattern.Stop(0.5, color()), new Pattern.Stop(0.5, color()), new Pattern.Stop(1, color()));
    }

    private Pattern.Lay lay() {
        Placement placement = placement();
        return new Pattern.Lay(placement.position(), placement.rotation(), placement.scale());
    }

    private Placement.Pivot pivot(boolean isGiven) {
        return isGiven ? new Placement.Point(vector()) : Placement.MIDDLE;
    }

    /** Of a body of operands and of operands: many of them within each other must not add up to something flat. */
    private Placement nested() {
        return placement().withScale(new Vec3(1 + random.nextDouble(), 1 + random.nextDouble(), -1 - random.nextDouble()));
    }

    private Placement placement() {
        return random.nextBoolean() ? Placement.NONE
                : new Placement(vector(), random.nextBoolean() ? Vec3.ZERO : vector(), random.nextBoolean() ? new Vec3(2, 2, 2) : new Vec3(factor(), -factor(), factor()));
    }

    /** Not so small or large that a few of them, nested, are out of all proportion. */
    private double factor() {
        return 0.3 + 3 * random.nextDouble();
    }

    private Rgb color() {
        return random.nextBoolean() ? new Rgb(random.nextInt(256), random.nextInt(256), random.nextInt(256))
                : Rgb.ofLinear(random.nextDouble(), random.nextDouble(), random.nextDouble());
    }

    private Vec3 vector() {
        return new Vec3(number() - 1, -number(), number());
    }

    /** Above 0, from very small to thousands. */
    private double number() {
        return (0.1 + random.nextDouble()) * Math.pow(10, random.nextInt(12) - 8);
    }
}
