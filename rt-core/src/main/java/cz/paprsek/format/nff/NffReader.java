package cz.paprsek.format.nff;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Notes;
import cz.paprsek.format.model.Polygon;
import cz.paprsek.format.model.TextLines;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.mesh.Triangles;
import cz.paprsek.text.Numbers;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * Reads NFF. Colours and lights are linear; a light without a colour is 1/√n bright if there are n. A cone is closed, where the format's is open: that shows only to who
 * looks into one. Polygons of one material that follow each other are one mesh.
 *
 * @source Haines, Neutral File Format, version 3.1, in the Standard Procedural Databases
 */
public final class NffReader {
    private final TextLines lines;
    private final Notes notes;
    private final Function<Triangles, Solid> meshes;
    private final List<SceneObject> objects = new ArrayList<>();
    private final List<PointLight> lights = new ArrayList<>();
    private final List<Boolean> hasOwnColor = new ArrayList<>();
    private Material material = Material.DEFAULT;
    private Rgb background = Rgb.BLACK;
    private Optional<Camera> camera = Optional.empty();
    private int width = 512;
    private int height = 512;
    private final Polygon polygon = new Polygon();
    private Optional<Triangles.Builder> mesh = Optional.empty();

    private NffReader(TextLines lines, Notes notes, Function<Triangles, Solid> meshes) {
        this.lines = lines;
        this.notes = notes;
        this.meshes = meshes;
    }

    /**
     * The scene, as large and as deep (5 levels) as is usual for the Standard Procedural Databases.
     *
     * @param meshes makes solids of triangles
     * @throws IOException if something is wrong with it; in one line that begins with the number of a line
     */
    public static Scene read(InputStream input, Notes notes, Function<Triangles, Solid> meshes) throws IOException {
        return new NffReader(new TextLines(input, false), notes, meshes).read();
    }

    private Scene read() throws IOException {
        while (lines.next()) {
            if (lines.word() && lines.letter(0) != '#') {
                try {
                    line();
                } catch (IllegalArgumentException impossible) {
                    throw lines.fault(String.valueOf(impossible.getMessage()));
                }
            }
        }
        finishMesh();
        if (camera.isEmpty()) {
            throw FormatFault.in("the end", "there is no view (v) in this file");
        }
        double usual = lights.isEmpty() ? 1 : 1 / Math.sqrt(lights.size());
        List<Light> all = new ArrayList<>();
        for (int i = 0; i < lights.size(); i++) {
            all.add(hasOwnColor.get(i) ? lights.get(i) : lights.get(i).withIntensity(usual));
        }
        return Scene.EMPTY.withSettings(new RenderSettings(width, height, 5, 1)).withBackground(background).withCamera(camera.get()).withLights(all).withObjects(objects);
    }

    private void line() throws IOException {
        if (!lines.is("p") && !lines.is("pp")) {
            finishMesh();
        }
        if (lines.is("v")) {
            view();
        } else if (lines.is("b")) {
            background = color();
        } else if (lines.is("l")) {
            light();
        } else if (lines.is("f")) {
            fill();
        } else if (lines.is("s")) {
            Vec3 centre = place();
            objects.add(SceneObject.of(new Sphere(lines.nextNumber("the radius of a ball"))).at(centre.x(), centre.y(), centre.z()).madeOf(material));
        } else if (lines.is("c")) {
            cone();
        } else if (lines.is("p") || lines.is("pp")) {
            polygon(lines.is("pp"));
        } else {
            throw lines.fault("here must be one of v, b, l, f, c, s, p, pp, but is " + FormatFault.quoted(lines.text()));
        }
    }

    private Vec3 place() throws IOException {
        return new Vec3(lines.nextNumber("x"), lines.nextNumber("y"), lines.nextNumber("z"));
    }

    private double[] light3() throws IOException {
        return new double[] {Math.max(0, lines.nextNumber("red")), Math.max(0, lines.nextNumber("green")), Math.max(0, lines.nextNumber("blue"))};
    }

    private Rgb color() throws IOException {
        double[] rgb = light3();
        return Rgb.ofLinear(Math.min(1, rgb[0]), Math.min(1, rgb[1]), Math.min(1, rgb[2]));
    }

    private void keyword(String wanted) throws IOException {
        boolean isFound = false;
        while (!isFound) {
            if (lines.hasMore()) {
                lines.word();
                isFound = true;
            } else if (!lines.next()) {
                throw lines.fault("the file ends before \"" + wanted + "\"");
            }
        }
        if (!lines.is(wanted)) {
            throw lines.fault("here must be \"" + wanted + "\", but is " + FormatFault.quoted(lines.text()));
        }
    }

    /** The angle goes from the middle of the lowest row of pixels to that of the highest. */
    private void view() throws IOException {
        keyword("from");
        Vec3 from = place();
        keyword("at");
        Vec3 at = place();
        keyword("up");
        Vec3 up = place();
        keyword("angle");
        double angle = lines.nextNumber("the angle");
        keyword("hither");
        lines.nextNumber("hither");
        keyword("resolution");
        width = pixels("the width");
        height = pixels("the height");
        if (!(angle > 0 && angle < 180)) {
            throw lines.fault("the angle must be above 0 and below 180, but is " + Numbers.text(angle));
        }
        double half = Angles.tan(angle / 2) * (height > 1 ? (double) height / (height - 1) : 1);
        camera = Optional.of(new Camera(from, new Camera.Target(at), up, 2 * StrictMath.toDegrees(StrictMath.atan(half))));
    }

    private int pixels(String what) throws IOException {
        double value = lines.nextNumber(what);
        if (!(value >= 1 && value <= 32768 && value == Math.rint(value))) {
            throw lines.fault(what + " must be a whole number from 1 to 32768, but is " + value);
        }
        return (int) value;
    }

    private void light() throws IOException {
        Vec3 position = place();
        boolean isColored = lines.hasMore();
        PointLight light = Light.at(position.x(), position.y(), position.z());
        if (isColored) {
            double[] rgb = light3();
            double most = Math.max(1, Math.max(rgb[0], Math.max(rgb[1], rgb[2])));
            light = light.withColor(Rgb.ofLinear(rgb[0] / most, rgb[1] / most, rgb[2] / most)).withIntensity(most);
        }
        lights.add(light);
        hasOwnColor.add(isColored);
    }

    private void fill() throws IOException {
        Rgb color = color();
        double diffusion = share("Kd");
        double specular = share("Ks");
        double shine = Math.max(0, Math.min(1e6, lines.nextNumber("Shine")));
        double transparency = share("T");
        double index = lines.nextNumber("the index of refraction");
        material = Material.color(color).withDiffusion(diffusion).withHighlight(specular, shine).withReflection(specular)
                .withTransparency(transparency, transparency > 0 && index > 0 ? index : 1);
    }

    private double share(String what) throws IOException {
        return Math.max(0, Math.min(1, lines.nextNumber(what)));
    }

    private void cone() throws IOException {
        keyword4();
        Vec3 base = place();
        double baseRadius = lines.nextNumber("the radius of the base");
        keyword4();
        Vec3 apex = place();
        double apexRadius = lines.nextNumber("the radius of the apex");
        notes.line(lines.line(), "cones and cylinders are closed");
        boolean isUpright = baseRadius >= apexRadius;
        Vec3 foot = isUpright ? base : apex;
        Vec3 axis = isUpright ? apex.minus(base) : base.minus(apex);
        double wide = Math.max(baseRadius, apexRadius);
        double narrow = Math.min(baseRadius, apexRadius);
        double length = axis.length();
        if (!(length > 0) || !(wide > 0) || narrow < 0) {
            throw lines.fault("a cone must have a length and a radius above 0");
        }
        Solid solid = wide == narrow ? new Cylinder(wide, length) : new Cone(wide, narrow, length);
        // Turned about x first, from y to the slope of the axis, then about y.
        double tilt = StrictMath.toDegrees(StrictMath.atan2(Math.sqrt(axis.x() * axis.x() + axis.z() * axis.z()), axis.y()));
        double around = StrictMath.toDegrees(StrictMath.atan2(axis.x(), axis.z()));
        objects.add(SceneObject.of(solid).placed(new Placement(foot, new Vec3(tilt, around, 0), Vec3.ONE)).madeOf(material));
    }

    /** The numbers of a cone or polygon may stand in lines of their own. */
    private void keyword4() throws IOException {
        while (!lines.hasMore()) {
            if (!lines.next()) {
                throw lines.fault("the file ends within a body");
            }
        }
    }

    private void polygon(boolean hasNormals) throws IOException {
        double count = lines.nextNumber("the number of corners");
        if (!(count >= 3 && count <= 1_000_000 && count == Math.rint(count))) {
            throw lines.fault("a polygon has from 3 to 1000000 corners, but this one has " + count);
        }
        Triangles.Builder builder = mesh.orElseGet(Triangles::builder);
        mesh = Optional.of(builder);
        polygon.clear();
        for (int i = 0; i < (int) count; i++) {
            keyword4();
            Vec3 corner = place();
            int vertex = builder.vertex(corner.x(), corner.y(), corner.z());
            if (hasNormals) {
                Vec3 normal = place();
                builder.normal(vertex, normal.x(), normal.y(), normal.z());
            }
            polygon.add(vertex, corner.x(), corner.y(), corner.z());
        }
        polygon.cut(builder::triangle);
        if (polygon.isHurried()) {
            notes.line(lines.line(), Polygon.HURRIED);
        }
    }

    private void finishMesh() {
        mesh.filter(builder -> builder.triangleCount() > 0).ifPresent(builder -> objects.add(SceneObject.of(meshes.apply(builder.build())).madeOf(material)));
        mesh = Optional.empty();
    }
}
