import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Breaks the formulas of the ray tracer one after the other, each in the way in which a well-known report has it wrong, and runs the tests:
 * {@code java .ci/BreakFormulas.java [WORD …]}, about half a minute for each; with words, only breaks whose names hold one of them.
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
            new Break("normal of a sphere 2(P − S)", "shape/Sphere.java", "hit.unitNormal(hit.px - x, hit.py - y, hit.pz - z);",
                    "hit.nx = 2 * (hit.px - x); hit.ny = 2 * (hit.py - y); hit.nz = 2 * (hit.pz - z);"),
            new Break("normals not turned to the viewer", "render/Tracer.java", "hit.nx = -hit.nx;\n            hit.ny = -hit.ny;\n            hit.nz = -hit.nz;", ""),
            new Break("hits without offset", "shape/Ray.java", "min = OFFSET * size;", "min = 0;"),
            new Break("sign of the rectangle's t", "shape/Flat.java", "double t = -toLocal.pointZ", "double t = toLocal.pointZ"),
            new Break("rectangle seen from one side only", "shape/Flat.java", "if (dz == 0 ||", "if (dz >= 0 ||"),
            new Break("checkerboard without clamp", "render/Paint.java", "Math.min((int) (hit.u * columns), columns - 1)", "(int) (hit.u * columns)"),
            new Break("squares of a checkerboard swapped", "render/Paint.java", "(column + row) % 2 != 0", "(column + row) % 2 == 0"),
            new Break("ellipsoid with w = 0", "shape/Ellipsoid.java", "double half = 1 - (px", "double half = 0 - (px"),
            new Break("only the smaller t", "shape/Convex.java", "} else if (ray.leave > ray.min", "} else if (ray.leave < ray.min"),
            new Break("−b ± √d", "shape/Cone.java", "double t1 = c / q;", "double t1 = (-b + Math.copySign(Math.sqrt(discriminant), b)) / a;"),
            new Break("normals of a subtracted solid not turned", "shape/Spans.java", "!changedA && operation == Operation.DIFFERENCE", "false"),
            new Break("one interval of CSG", "shape/Csg.java", "out.combine(operation, left, right, ray.scale);",
                    "out.combine(operation, left, right, ray.scale); if (out.size() > left + 2) { out.release(left + 2); }"),
            new Break("diffuse light not clamped", "render/Tracer.java", "if (!(facing > 0)) {", "if (Double.isNaN(facing)) {"),
            new Break("reflection with the sign turned", "render/Tracer.java", "mirrorX = ray.dx + 2 * c * hit.nx;", "mirrorX = ray.dx - 2 * c * hit.nx;"),
            new Break("highlight not clamped", "render/Finish.java", "if (!(cosine > 0) || specular == 0) {", "if (specular == 0) {"),
            new Break("mirrors that see nothing are black", "render/Tracer.java", "level.light(background[0], background[1], background[2]);",
                    "if (depth == 0) { level.light(background[0], background[1], background[2]); } else { level.light(0, 0, 0); }"),
            new Break("one level of rays too many", "render/Tracer.java", "new Surface[maxDepth * lamps.length]", "new Surface[++maxDepth * lamps.length]"),
            new Break("Snell upside down", "render/Tracer.java", "double t = 1 + e * e * (c * c - 1);", "double t = 1 + (c * c - 1) / (e * e);"),
            new Break("no total internal reflection", "render/Tracer.java", "reflection += finish.transparency;", "reflection += 0;"),
            new Break("shadows from beyond the light", "render/Tracer.java", "distance - Ray.OFFSET * size)", "Double.POSITIVE_INFINITY)"),
            new Break("glass casts full shadows", "render/Tracer.java", "double share = parts.finish(spans.part(mark + i)).transparency;", "double share = 0;"),
            new Break("white light only", "render/Lamp.java", "light.color().linearGreen() * light.intensity()", "light.color().linearRed() * light.intensity()"),
            new Break("no rotation", "shape/Placement.java", "rotation.equals(Vec3.ZERO) ? Affine.IDENTITY : Affine.rotation(rotation)", "Affine.IDENTITY"),
            new Break("turns in another order", "math/Affine.java", "cz * sy * sx - sz * cx", "cz * sy * sx + sz * cx"));

    private static final String TESTS = "ClosedFormTest,ReferenceSceneTest,TextbookTest,ShapeContractTest,CsgTest,CrossCheckTest,MetamorphicTest,RendererTest";
    private static final Pattern FAILED = Pattern.compile("\\[ERROR\\] +(\\w+Test\\.\\w+)");

    public static void main(String[] words) throws IOException, InterruptedException {
        Path copy = Files.createTempDirectory("breaks");
        run(Path.of("."), "git", "clone", "-q", ".", copy.toString());
        Path module = copy.resolve("rt-core");
        Path pom = copy.resolve("pom.xml");
        // What the compiler warns of is not the question here.
        Files.writeString(pom, Files.readString(pom).replaceAll("<arg>-(Werror|Xplugin).*</arg>", ""));
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
            String output = run(copy, "mvn", "-o", "-B", "-pl", "rt-core", "test", "-Dtest=" + TESTS, "-Dsurefire.skipAfterFailureCount=1");
            Files.writeString(file, good);
            if (output.contains("COMPILATION ERROR")) {
                throw new IllegalStateException(formula.name() + " does not compile:\n" + output);
            }
            Matcher failed = FAILED.matcher(output);
            boolean isNoticed = output.contains("There are test failures") && failed.find();
            tried++;
            unnoticed += isNoticed ? 0 : 1;
            System.out.println((isNoticed ? "noticed by " + failed.group(1) : "NOT NOTICED") + ": " + formula.name());
        }
        System.out.println(tried + " formulas broken, " + (tried - unnoticed) + " noticed");
        System.exit(unnoticed == 0 ? 0 : 1);
    }

    private static String run(Path folder, String... command) throws IOException, InterruptedException {
        Path output = Files.createTempFile("breaks", ".log");
        Process process = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).redirectOutput(output.toFile()).start();
        if (!process.waitFor(10, TimeUnit.MINUTES)) {
            process.destroyForcibly();
        }
        String text = Files.readString(output);
        Files.delete(output);
        return text;
    }
}
