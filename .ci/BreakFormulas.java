import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/**
 * Breaks the formulas of the ray tracer one after the other, each in the way in which a well-known report has it wrong, and runs the tests:
 * {@code java .ci/BreakFormulas.java [WORD …]}; with words, only breaks whose names hold one of them. Of each, one file is compiled anew.
 * Fails if a break goes unnoticed. Works in a copy of the last commit.
 */
public class BreakFormulas {
    record Break(String name, String file, String right, String wrong) {}

    private static final List<Break> BREAKS = List.of(
            new Break("height of the picture from tan(fovy)", "render/eye/Pinhole.java", "Angles.tan(lens.fovy() / 2)", "Angles.tan(lens.fovy())"),
            new Break("rays through corners of pixels", "render/eye/Pinhole.java", "double directionX(double x, double y) {", "double directionX(double x, double y) { x -= 0.5; y -= 0.5;"),
            new Break("up vector as given", "scene/Camera.java", "return right().cross(forward());", "return up.normalized();"),
            new Break("right vector not of length 1", "scene/Camera.java", "forward().cross(upwards().normalized()).normalized()", "forward().cross(upwards().normalized())"),
            new Break("radius taken for a diameter", "shape/Sphere.java", "place(toWorld, radius, radius, radius, parts)", "place(toWorld, radius / 2, radius / 2, radius / 2, parts)"),
            new Break("normal of a sphere 2(P − S)", "shape/placed/Ball.java", "hit.normal(hit.px - x, hit.py - y, hit.pz - z);",
                    "hit.unitNormal(2 * (hit.px - x), 2 * (hit.py - y), 2 * (hit.pz - z));"),
            new Break("normals not turned to the viewer", "render/integrate/Shading.java", "if (level.leaving) {\n            hit.turn();", "if (level.leaving) {"),
            new Break("hits without offset", "shape/placed/Ray.java", "left = surface;\n        inwards = intoIt;\n        contact = TOUCH * size;",
                    "left = -1;\n        inwards = intoIt;\n        contact = 0;"),
            new Break("sign of the rectangle's t", "shape/placed/Flat.java", "double t = -z / dz;", "double t = z / dz;"),
            new Break("rectangle seen from one side only", "shape/placed/Flat.java", "if (dz == 0 ||", "if (dz >= 0 ||"),
            new Break("checkerboard without clamp", "render/surface/TwoColors.java", "Math.min((int) (hit.u * columns), columns - 1)", "(int) (hit.u * columns)"),
            new Break("squares of a checkerboard swapped", "render/surface/TwoColors.java", "(column + row) % 2 != 0", "(column + row) % 2 == 0"),
            new Break("ellipsoid with w = 0", "shape/Ellipsoid.java", "double half = 1 - (px", "double half = 0 - (px"),
            new Break("only the smaller t", "shape/placed/Convex.java", "} else if (ray.leave > ray.min", "} else if (ray.leave < ray.min"),
            new Break("−b ± √d", "shape/Cone.java", "double t1 = c / q;", "double t1 = (-b + Math.copySign(Math.sqrt(discriminant), b)) / a;"),
            new Break("normals of a subtracted solid not turned", "shape/placed/Spans.java", "boolean flipped = !changedA && flips;", "boolean flipped = false;"),
            new Break("one interval of CSG", "shape/placed/Volume.java", "out.combine(operation, left, right, ray.scale);",
                    "out.combine(operation, left, right, ray.scale); if (out.size() > left + 2) { out.release(left + 2); }"),
            new Break("diffuse light not clamped", "render/integrate/Lighting.java", "if (!shines || !(facing > 0)) {", "if (!shines) {"),
            new Break("reflection with the sign turned", "render/integrate/Shading.java", "mirrorX = ray.dx + 2 * c * hit.sx;", "mirrorX = ray.dx - 2 * c * hit.sx;"),
            new Break("highlight not clamped", "render/surface/Finish.java", "if (!(cosine > 0) || specular == 0) {", "if (specular == 0) {"),
            new Break("mirrors that see nothing are black", "render/integrate/Shading.java", "level.light(level.hit.red, level.hit.green, level.hit.blue);",
                    "if (level == levels[1]) { level.light(0, 0, 0); } else { level.light(level.hit.red, level.hit.green, level.hit.blue); }"),
            new Break("one level of rays too many", "render/integrate/Whitted.java", "super(scene, maxDepth, sampling, false", "super(scene, ++maxDepth, sampling, false"),
            new Break("Snell upside down", "render/integrate/Whitted.java", "double t = 1 + e * e * (c * c - 1);", "double t = 1 + (c * c - 1) / (e * e);"),
            new Break("no total internal reflection", "render/integrate/Whitted.java", "reflection += finish.transparency;", "reflection += 0;"),
            new Break("shadows from beyond the light", "render/integrate/Lighting.java", "arrival.distance - Ray.TOUCH * hit.size, ray.part,\n                level.leaving != ", "Double.POSITIVE_INFINITY, ray.part,\n                level.leaving != "),
            new Break("glass casts full shadows", "render/integrate/Veils.java", "double share = transparency(ray, spans, i);", "double share = 0;"),
            new Break("white light only", "render/light/Lamp.java", "green = color.linearGreen()", "green = color.linearRed()"),
            new Break("no rotation", "shape/Placement.java", ".after(Affine.rotation(rotation))", ""),
            new Break("turns in another order", "math/Affine.java", "cz * sy * sx - sz * cx", "cz * sy * sx + sz * cx"),
            // Lights.
            new Break("light falls with the distance, not its square", "render/light/FadingLamp.java", "square / (out.distance * out.distance)", "square / out.distance"),
            new Break("edge of a spot without smoothing", "render/light/SpotLamp.java", "return t * t * (3 - 2 * t);", "return t;"),
            new Break("spot by its full angle", "render/light/SpotLamp.java", "Angles.cos(light.outerAngle())", "Angles.cos(light.outerAngle() / 2)"),
            new Break("area light without its own cosine", "render/light/AreaLamp.java", "arrives(cosine * (square", "arrives((square"),
            new Break("area light that shines to both sides", "render/light/AreaLamp.java", "return cosine > 0 &&", "cosine = Math.abs(cosine);\n        return"),
            new Break("points of a disc crowded in its middle", "render/light/Unit.java", "double a = 2 * u - 1;\n        double b = 2 * v - 1;", "double a = (2 * u - 1) * Math.abs(2 * u - 1);\n        double b = (2 * v - 1) * Math.abs(2 * v - 1);"),
            new Break("radiance of a ball from its diameter", "render/light/BallLamp.java", "double by = light.referenceDistance() / radius;", "double by = light.referenceDistance() / (2 * radius);"),
            new Break("sun of twice its angle", "render/light/SunDiscLamp.java", "depth = sine * sine / (1 + cosine);", "depth = 4 * sine * sine / (1 + cosine);"),
            new Break("sum of a light's samples for their mean", "render/integrate/Lighting.java", "double share = 1.0 / samples;", "double share = 1;"),
            // Lenses.
            new Break("focus along the ray, not along the view", "render/eye/ThinLens.java", "double dx = focus * directionX(x, y) - lx;",
                    "double along = Math.sqrt(directionX(x, y) * directionX(x, y) + directionY(x, y) * directionY(x, y) + directionZ(x, y) * directionZ(x, y));\n        double dx = focus / along * directionX(x, y) - lx;"),
            new Break("lens moved, its rays not turned", "render/eye/ThinLens.java", "double dy = focus * directionY(x, y) - ly;", "double dy = focus * directionY(x, y);"),
            new Break("orthographic height taken for half", "render/eye/Parallel.java", "high = lens.height();", "high = 2 * lens.height();"),
            new Break("spherical picture upside down", "render/eye/Globe.java", "double latitude = (0.5 - y * perRow) * 180;\n        double level", "double latitude = (y * perRow - 0.5) * 180;\n        double level"),
            new Break("fisheye by the tangent", "render/eye/Circle.java", "return radius == 0 ? 0 : Angles.sin(radius * angle / 2) / radius;", "return radius == 0 ? 0 : Angles.sin(radius * angle / 2);"),
            new Break("tent twice as wide", "render/sample/Strewing.java", "CENTRE - (1 - Math.sqrt(2 * u))", "CENTRE - 2 * (1 - Math.sqrt(2 * u))"),
            // Surfaces.
            new Break("only one polarisation", "render/integrate/Shares.java", "return (s * s + p * p) / 2;", "return s * s;"),
            new Break("Fresnel with the angles swapped", "render/integrate/Shares.java", "double s = (from * cosine - to * beyond) / across;", "double s = (from * beyond - to * cosine) / across;"),
            new Break("Schlick's exponent 4", "render/integrate/Shares.java", "return square * square * rest;", "return square * square;"),
            new Break("what is mirrored is let through, too", "render/integrate/Shares.java", "finish.transparency * (1 - finish.reflection * share);", "finish.transparency;"),
            new Break("absorption by powers of two", "render/surface/Absorption.java", "StrictMath.exp(-depth)", "StrictMath.pow(2, -depth)"),
            new Break("absorption without its distance", "render/surface/Absorption.java", "double distance = material.attenuationDistance();", "double distance = 1;"),
            new Break("α for roughness", "render/surface/Finish.java", "alpha = value * value;", "alpha = value;"),
            new Break("GGX without the square of its root", "render/integrate/Ggx.java", "return square / (Math.PI * t * t);", "return square / (Math.PI * t);"),
            new Break("facets not weighed by what is seen", "render/integrate/Ggx.java", "return 2 * cosine / (cosine + Math.sqrt(square + (1 - square) * c));", "return 1;"),
            new Break("rough mirror without 4 cos", "render/integrate/Lobe.java", "double k = Math.PI * spread * seen * lit / (4 * facing);", "double k = Math.PI * spread * seen * lit;"),
            new Break("emission without its strength", "render/surface/Finish.java", "red = material.emission().linearRed() * material.emissionStrength();", "red = material.emission().linearRed();"),
            // Textures and sky.
            new Break("colours of a ramp mixed from the wrong end", "render/surface/MixedColors.java", "channels[lower] + share * (channels[upper] - channels[lower])", "channels[upper] + share * (channels[lower] - channels[upper])"),
            new Break("sky by angle, not by height", "render/surface/Backdrop.java", "double share = Math.min(1, Math.abs(y));", "double share = Math.min(1, Math.abs(StrictMath.asin(Math.max(-1, Math.min(1, y)))) * 2 / Math.PI);"),
            new Break("sky picture mirrored", "render/glow/SkyPicture.java", "StrictMath.atan2(dz, dx)", "StrictMath.atan2(-dz, dx)"),
            // Bumps, and shares by pattern.
            new Break("bumps for dents", "render/surface/Bending.java", "hit.bend(k * hit.sx - strength * gx, k * hit.sy - strength * gy, k * hit.sz - strength * gz);",
                    "hit.bend(k * hit.sx + strength * gx, k * hit.sy + strength * gy, k * hit.sz + strength * gz);"),
            new Break("all of a bump's slope, also what is across the surface", "render/surface/Bending.java", "double c = (gx * qx + gy * qy + gz * qz) / (hit.sx * qx + hit.sy * qy + hit.sz * qz);",
                    "gx = slope[0];\n            gy = slope[1];\n            gz = slope[2];\n            double c = 0;"),
            new Break("bumps that grow steeper with their object", "render/surface/Bending.java", "double k = 1 / Math.sqrt(wx * wx + wy * wy + wz * wz) + strength * c;", "double k = 1 + strength * c;"),
            new Break("normal map with v down", "render/surface/Bending.java", "strength * (2 * probe.green - 1)", "strength * (1 - 2 * probe.green)"),
            new Break("strength of a normal map on its z, too", "render/surface/Bending.java", "2 * probe.blue - 1, level.hit", "strength * (2 * probe.blue - 1), level.hit"),
            new Break("bumps of marble without its turbulence", "render/texture/ValueField.java", "double bent = steep * marble.turbulence();", "double bent = 0;"),
            new Break("bumps of wood along x only", "render/texture/ValueField.java", "outwards * z + bent * out[2]", "bent * out[2]"),
            new Break("bent normals that the viewer sees from behind", "render/integrate/Bent.java", "if (away > 0) {", "if (away > 1) {"),
            new Break("mirrored rays that go into the surface", "render/integrate/Bent.java", "return -2 * (beyond ? Math.max(0, along) : Math.min(0, along));", "return 0;"),
            new Break("light from behind on bumps", "render/integrate/Bent.java", "return (itself > 0) == (facing > 0) || (hit.isRounded && facing > 0 && itself > -ROUNDED) ? facing : 0;", "return facing;"),
            new Break("shares decoded as if they were light", "render/surface/Variety.java", "Paint.of(by.pattern(), toDeclared, textures, false)", "Paint.of(by.pattern(), toDeclared, textures, true)"),
            new Break("luminance as the mean of three", "material/Share.java", "0.2126 * red + 0.7152 * green + 0.0722 * blue", "(red + green + blue) / 3"),
            new Break("the pattern's smallest share for its greatest", "material/Share.java", "mapToDouble(channel::of).max().orElse(1)", "mapToDouble(channel::of).min().orElse(1)"));

    /** The quick ones first. */
    private static final List<String> TESTS = List.of("ReferenceSceneTest", "TextbookTest", "EyeTest", "AbsorptionTest", "SlopeTest", "ClosedFormTest", "FresnelTest", "ReliefTest",
            "PictureTest", "LensTest", "LightsTest", "PatternTest", "StrewingTest", "RoughTest", "MetamorphicTest", "CrossCheckTest", "RendererTest", "CsgTest", "ShapeContractTest");

    public static void main(String[] words) throws IOException, InterruptedException {
        Path copy = Files.createTempDirectory("breaks");
        run(Path.of("."), "git", "clone", "-q", ".", copy.toString());
        Path module = copy.resolve("rt-core");
        Path jars = copy.resolve("jars");
        String built = run(copy, "mvn", "-o", "-B", "-pl", "rt-core", "test-compile", "dependency:build-classpath", "-Dmdep.outputFile=" + jars);
        if (!built.contains("BUILD SUCCESS")) {
            throw new IllegalStateException("what is not broken does not compile:\n" + built);
        }
        String path = Files.readString(jars).strip();
        String tests = String.join(File.pathSeparator, copy.toString(), module.resolve("target/test-classes").toString(), module.resolve("target/classes").toString(), path);
        if (ToolProvider.getSystemJavaCompiler().run(null, null, null, "-cp", path, "-d", copy.toString(), copy.resolve(".ci/FirstFailure.java").toString()) != 0) {
            throw new IllegalStateException("FirstFailure does not compile");
        }
        // A short life: the second compiler would not pay.
        List<String> command = new ArrayList<>(List.of("java", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-Xmx2g", "-Djava.awt.headless=true", "-cp", tests, "FirstFailure"));
        for (String test : TESTS) {
            command.add(fullName(module.resolve("src/test/java"), test));
        }
        int unnoticed = 0;
        int tried = 0;
        for (Break formula : BREAKS) {
            if (words.length > 0 && List.of(words).stream().noneMatch(formula.name()::contains)) {
                continue;
            }
            Path file = module.resolve("src/main/java/cz/paprsek").resolve(formula.file());
            String good = Files.readString(file);
            if (!good.contains(formula.right())) {
                throw new IllegalStateException(formula.file() + " has no " + formula.right() + " any more: bring the table up to date");
            }
            Files.writeString(file, good.replace(formula.right(), formula.wrong()));
            boolean compiles = compile(file, module, path);
            String answer = compiles ? run(module, command.toArray(String[]::new)) : "";
            Files.writeString(file, good);
            if (!compiles || !compile(file, module, path)) {
                throw new IllegalStateException(formula.name() + " does not compile");
            }
            tried++;
            String noticed = answer.lines().filter(line -> line.startsWith("noticed by ")).findFirst().orElse("NOT NOTICED");
            unnoticed += noticed.startsWith("noticed") ? 0 : 1;
            System.out.println(noticed + ": " + formula.name());
        }
        System.out.println(tried + " formulas broken, " + (tried - unnoticed) + " noticed");
        System.exit(unnoticed == 0 ? 0 : 1);
    }

    private static String fullName(Path tests, String name) throws IOException {
        try (Stream<Path> files = Files.walk(tests)) {
            Path file = files.filter(one -> one.endsWith(name + ".java")).findFirst().orElseThrow();
            return tests.relativize(file).toString().replace(File.separatorChar, '.').replaceAll("\\.java$", "");
        }
    }

    /** Puts a file's classes in the place of those that are there. */
    private static boolean compile(Path file, Path module, String path) {
        return ToolProvider.getSystemJavaCompiler().run(null, null, null, "--release", "17", "-g", "-nowarn", "-proc:none", "-implicit:none",
                "-encoding", "UTF-8", "-XDstringConcat=inline", "--module-path", path, "-d", module.resolve("target/classes").toString(), file.toString()) == 0;
    }

    private static String run(Path folder, String... command) throws IOException, InterruptedException {
        Path output = Files.createTempFile("breaks", ".log");
        Process process = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).redirectOutput(output.toFile()).start();
        // Far longer than it takes, also on a machine that has much else to do.
        if (!process.waitFor(40, TimeUnit.MINUTES)) {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly();
        }
        String text = Files.readString(output);
        Files.delete(output);
        return text;
    }
}
