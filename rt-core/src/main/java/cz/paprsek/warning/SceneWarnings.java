package cz.paprsek.warning;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PlacedLight;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.MaterialAt;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Csg.Operation;
import cz.paprsek.shape.Isosurface;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Text;
import cz.paprsek.shape.height.HeightField;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.shape.placed.Volume;
import cz.paprsek.text.Numbers;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** What is allowed in a scene, but hardly what its author meant. */
public final class SceneWarnings {
    /** Sums of decimals such as 0.1 + 0.7 + 0.2 may come out a little above 1. */
    private static final double SLACK = 1e-9;
    /** The least share of light that a clear body lets through. */
    private static final double CLEAR = 0.5;
    /** Along each side of a pixel. */
    private static final int FEWEST_FOR_LENS = 3;

    private final Scene scene;
    private final Nests nests;
    private final List<SceneWarning> warnings = new ArrayList<>();
    private final List<GlassContacts.Body> transparent = new ArrayList<>();

    private SceneWarnings(Scene scene) {
        this.scene = scene;
        this.nests = new Nests(scene);
    }

    /**
     * All that is suspicious about a scene; where bodies lie whose files have not been read, or hold what cannot be an operand, nobody knows. Of an object of
     * more than {@value Nests#LARGEST} primitives, only materials are looked at.
     */
    public static List<SceneWarning> of(Scene scene) {
        SceneWarnings check = new SceneWarnings(scene);
        List<BodyAt> parts = check.nests.bodies().filter(check::isSeen).toList();
        check.light(parts);
        check.suns();
        check.balls();
        check.lenses();
        check.materials(check.nests.bodies().toList());
        parts.forEach(check::formula);
        List<BodyAt> read = parts.stream().filter(part -> !check.nests.isVast(part) && isThere(part.in(scene).shape())).toList();
        read.forEach(check::operands);
        read.stream().filter(part -> part.depth() == 0).forEach(check::object);
        check.missing(parts);
        check.shining();
        check.glass();
        return check.warnings;
    }

    /** Of them those that tell why a picture of paths has grain; found at once. */
    public static List<SceneWarning> ofPaths(Scene scene) {
        SceneWarnings check = new SceneWarnings(scene);
        check.shining();
        return check.warnings;
    }

    /** Of them those that tell what is missing beside the files of meshes, where materials of these files are to be shown; found at once. */
    public static List<SceneWarning> ofMeshes(Scene scene) {
        SceneWarnings check = new SceneWarnings(scene);
        // Of a million balls none is asked by itself.
        check.missing(IntStream.range(0, scene.objects().size()).filter(i -> scene.objects().get(i).shape() instanceof Mesh || scene.objects().get(i).shape() instanceof Csg)
                .mapToObj(ScenePath::body).flatMap(check.nests::parts).filter(check::isSeen).toList());
        return check.warnings;
    }

    private boolean isSeen(BodyAt part) {
        return part.way().noneMatch(around -> around.in(scene).hidden());
    }

    /** Whether all that it is made of is there. */
    private static boolean isThere(Shape shape) {
        if (shape instanceof Csg csg) {
            return csg.operands().stream().map(Operand::solid).allMatch(solid -> isThere(solid) && !(solid instanceof Mesh mesh && !mesh.hasInside()));
        }
        return !(shape instanceof Mesh mesh && !mesh.isRead()) && !(shape instanceof Text text && !text.isRead()) && !(shape instanceof HeightField field && !field.isRead());
    }

    private void add(String kind, String message) {
        warnings.add(new SceneWarning(kind, "", Optional.empty(), "", message, false));
    }

    private void add(String kind, String object, ScenePath place, String message) {
        add(kind, object, place, "", message);
    }

    private void add(String kind, String object, ScenePath place, String attribute, String message) {
        warnings.add(new SceneWarning(kind, object, Optional.of(place), attribute, message, false));
    }

    private void light(List<BodyAt> parts) {
        boolean isLit = scene.lights().stream().anyMatch(light -> light.intensity() > 0 && !light.color().equals(Rgb.BLACK));
        for (int i = 0; i < scene.lights().size(); i++) {
            color(name(i), ScenePath.light(i), scene.lights().get(i).color());
        }
        if (parts.isEmpty()) {
            add("empty", "there are no objects; the picture will be the background alone");
        } else if (!isLit && scene.ambient().equals(Rgb.BLACK) && !shinesOtherwise(parts)) {
            add("dark", "there is no light and no ambient light; every surface will be black");
        }
    }

    /** Whether something other than a light is bright, or lights what paths meet. */
    private boolean shinesOtherwise(List<BodyAt> parts) {
        boolean hasSky = !(scene.sky() instanceof Scene.Sky.None) || !scene.background().equals(Rgb.BLACK);
        return (scene.settings().isPath() && hasSky) || parts.stream().anyMatch(part -> part.material(scene).shines()) || nests.materials().stream().anyMatch(nests::shines);
    }

    private void suns() {
        for (int i = 0; i < scene.lights().size(); i++) {
            if (scene.lights().get(i) instanceof SunLight sun && sun.visible() && sun.angle() == 0) {
                add("sun-without-disc", name(i), ScenePath.light(i), "visible", name(i) + " is visible but has no disc to be seen; give it an angle");
            }
        }
    }

    /** Within a ball there is no light, and from inside it is black. */
    private void balls() {
        for (int i = 0; i < scene.lights().size(); i++) {
            if (scene.lights().get(i) instanceof SphereLight ball && ball.visible()
                    && scene.camera().position().minus(ball.position()).length() < ball.radius()) {
                add("camera-inside", name(i), ScenePath.light(i), "the camera is inside " + name(i) + ", which is black from within; it will see nothing else");
            }
        }
    }

    /** One random point of a lens shows no blur, but grain. */
    private void lenses() {
        OptionalInt open = IntStream.range(0, scene.cameras().size())
                .filter(i -> scene.cameras().get(i).lens() instanceof Lens.Perspective lens && lens.aperture() > 0).findFirst();
        int most = scene.settings().mostRays();
        if (open.isPresent() && most < FEWEST_FOR_LENS * FEWEST_FOR_LENS) {
            add("lens-samples", "", ScenePath.camera(open.getAsInt()), "aperture", "a camera's lens has an aperture, but a pixel has " + (most == 1 ? "one ray" : most + " rays") + "; blur will be grain: give <render> samples=\"" + (scene.settings().isPath() ? RenderSettings.USUAL_PATHS : FEWEST_FOR_LENS + 1) + "\" or more");
        }
    }

    private void formula(BodyAt part) {
        if (part.in(scene).shape() instanceof Isosurface surface && surface.isEmpty()) {
            add("nowhere", label(part), part, "expression", label(part) + " is nowhere: its formula is not below 0 at any point of its box, from min to max");
        }
    }

    private void materials(List<BodyAt> parts) {
        Set<String> used = new HashSet<>();
        scene.materials().forEach((name, material) -> material("material \"" + name + "\"", new MaterialAt(name), material));
        for (BodyAt part : parts) {
            MaterialSource source = part.in(scene).material();
            if (source instanceof MaterialName reference) {
                used.add(reference.name());
            } else if (source instanceof Material own) {
                material("material of " + label(part), part, own);
            }
        }
        nests.materials().stream().filter(MaterialName.class::isInstance).forEach(source -> used.add(((MaterialName) source).name()));
        scene.materials().keySet().stream().filter(name -> !used.contains(name))
                .forEach(name -> add("unused", "material \"" + name + "\"", new MaterialAt(name), "material \"" + name + "\" is not used"));
    }

    private void material(String what, ScenePath place, Material material) {
        if (material.pattern() instanceof Pattern.Plain plain) {
            color(what, place, plain.color());
            milk(what, place, material, plain.color());
        }
        // What glass does not mirror it lets through.
        boolean isGlass = material.fresnel() == Fresnel.TRUE;
        double sum = material.diffusion() + (isGlass ? Math.max(material.reflection(), material.transparency()) : material.reflection() + material.transparency());
        sum = Math.min(sum, together(material, isGlass));
        if (sum > 1 + SLACK) {
            add("energy", what, place, what + (isGlass ? ": diffusion and the greater of reflection and transparency" : ": diffusion, reflection and transparency") + " add up to " + Numbers.text(Math.rint(sum * 1e6) / 1e6)
                    + "; above 1 a surface gives back more light than it gets");
        }
    }

    /** The greatest sum at any one point, if all shares that differ do so by one pattern, in other colours; else without bound: nobody knows where which of them meet. */
    private static double together(Material material, boolean isGlass) {
        List<Share.ByPattern> varied = Stream.of(material.shares().diffusion(), material.shares().reflection(), material.shares().transparency())
                .filter(Share.ByPattern.class::isInstance).map(Share.ByPattern.class::cast).toList();
        if (varied.size() < 2 || varied.stream().anyMatch(by -> !areAlike(by.pattern(), varied.get(0).pattern()))) {
            return Double.POSITIVE_INFINITY;
        }
        double most = 0;
        for (int i = 0; i < varied.get(0).pattern().palette().size(); i++) {
            double reflection = share(material.shares().reflection(), i, material.reflection());
            double transparency = share(material.shares().transparency(), i, material.transparency());
            most = Math.max(most, share(material.shares().diffusion(), i, material.diffusion()) + (isGlass ? Math.max(reflection, transparency) : reflection + transparency));
        }
        return most;
    }

    /** Whether two patterns have as many colours in the very same places, whatever they are; not if either does not say which it has. */
    private static boolean areAlike(Pattern one, Pattern other) {
        return one.getClass() == other.getClass() && one instanceof Record && !one.palette().isEmpty() && form(one).equals(form(other));
    }

    private static List<Object> form(Pattern pattern) {
        return Described.values((Record) pattern).values().stream().<Object>map(value -> value instanceof Rgb ? "" : value instanceof Pattern.Colors colors
                ? colors.stops().stream().map(Pattern.Stop::at).toList() : value).toList();
    }

    private static double share(Share share, int color, double even) {
        return share instanceof Share.ByPattern by ? by.channel().of(by.pattern().palette().get(color)) : even;
    }

    /** Where nothing is strewn, the colour is there for ambient light alone, and every surface that light meets on its way through adds some. */
    private void milk(String what, ScenePath place, Material material, Rgb color) {
        boolean isClear = material.diffusion() == 0 && material.transparency() >= CLEAR && material.fresnel() != Fresnel.METAL;
        if (isClear && !color.equals(Rgb.BLACK) && !scene.ambient().equals(Rgb.BLACK)) {
            add("milk", what, place, "color", what + " is clear, but ambient light makes it milky, for that counts with the color whatever the diffusion; give it color=\"0 0 0\"");
        }
    }

    /** In many other formats, colours go up to 1. */
    private void color(String what, ScenePath place, Rgb color) {
        double most = Math.max(color.red(), Math.max(color.green(), color.blue()));
        if (most > 0 && most <= 1) {
            add("color", what, place, "color", what + ": the color " + Numbers.text(color.red()) + " " + Numbers.text(color.green()) + " " + Numbers.text(color.blue())
                    + " is next to black; colours go up to 255");
        }
    }

    private void operands(BodyAt part) {
        if (!(part.in(scene).shape() instanceof Csg csg) || csg.operation() == Operation.UNION) {
            return;
        }
        Bounds left = csg.operands().get(0).hidden() ? Bounds.ALL : bounds(csg.operands().get(0));
        for (int i = 1; i < csg.operands().size(); i++) {
            Operand operand = csg.operands().get(i);
            if (operand.hidden()) {
                continue;
            }
            if (left.intersection(bounds(operand)).isEmpty()) {
                String label = label(part.child(i));
                add("operand", label, part.child(i), csg.operation() == Operation.DIFFERENCE
                        ? label + " removes nothing: it does not meet the first operand"
                        : label + " does not meet the operands before it; nothing is left of the intersection");
            }
            left = csg.operation() == Operation.DIFFERENCE ? left : left.intersection(bounds(operand));
        }
    }

    /** What a part is called, from itself outwards: {@code sphere #2 in difference "bowl"}. */
    private String label(BodyAt part) {
        return part.label(scene) + (part.depth() == 0 ? "" : " in " + label(part.parent()));
    }

    private static Bounds bounds(Operand operand) {
        return operand.solid().place(operand.placement().toParent(), Parts.UNTOLD).bounds();
    }

    /** Whether there is more to be seen inside of a body than the body. */
    private boolean isRoom(BodyAt body, Surface placed) {
        return placed.bounds().isFinite() && IntStream.range(0, scene.objects().size()).filter(i -> i != body.index() && !nests.isVast(ScenePath.body(i)) && isThere(scene.objects().get(i).shape()) && isSeen(ScenePath.body(i)))
                .mapToObj(i -> ScenePath.body(i).placed(scene).bounds()).anyMatch(bounds -> bounds.isFinite() && placed.contains(bounds.middle()));
    }

    private void object(BodyAt object) {
        String label = label(object);
        List<Material> made = object.withOperands(scene).filter(this::isSeen).filter(part -> !(part.in(scene).shape() instanceof Csg))
                .map(part -> part.material(scene)).toList();
        boolean isOpaque = made.stream().allMatch(material -> material.transparency() == 0);
        long indices = made.stream().filter(material -> material.transparency() > 0).mapToDouble(Material::refractiveIndex).distinct().count();
        if (indices > 1) {
            add("indices", label, object, label + " is transparent, but its operands have different refractive indices; one body has one index");
        }
        if (made.stream().filter(material -> material.transparency() > 0)
                .map(material -> List.of(material.attenuationColor(), material.attenuationDistance())).distinct().count() > 1) {
            add("indices", label, object, label + " is transparent, but its operands absorb differently; one body is of one substance, that of its first transparent operand");
        }
        Surface placed = object.placed(scene);
        if (!isOpaque && placed instanceof Volume volume) {
            double index = made.stream().filter(material -> material.transparency() > 0).findFirst().orElseThrow().refractiveIndex();
            transparent.add(new GlassContacts.Body(object, label, volume, index));
        }
        if (placed.contains(scene.camera().position()) && !(isOpaque && isRoom(object, placed))) {
            add("camera-inside", label, object, "the camera is inside " + label + (isOpaque ? ", which is opaque; it will see nothing else" : ""));
        }
        for (int i = 0; i < scene.lights().size(); i++) {
            Light light = scene.lights().get(i);
            if (isOpaque && light instanceof PlacedLight lamp && extent(lamp).allMatch(placed::contains)) {
                add("light-inside", name(i), ScenePath.light(i), name(i) + " is inside " + label + ", which is opaque; it lights nothing outside");
            }
        }
    }

    /** Of each file once, however often it is shown. */
    private void missing(List<BodyAt> parts) {
        Set<String> told = new HashSet<>();
        for (BodyAt part : parts) {
            if (part.in(scene).shape() instanceof Mesh mesh && part.source(scene) == Inherited.INHERITED && !mesh.missing().isEmpty() && told.add(mesh.file())) {
                mesh.missing().forEach(sentence -> add("missing", label(part), part, "file", label(part) + ": " + sentence));
            }
        }
    }

    /** Of what shines, paths look for some shapes only. */
    private void shining() {
        for (int i = 0; i < scene.objects().size() && scene.settings().isPath(); i++) {
            BodyAt object = ScenePath.body(i);
            if (!scene.objects().get(i).hidden() && !scene.objects().get(i).isSoughtIfItShines() && nests.shines(object)) {
                String label = label(object);
                add("shines-by-chance", label, object, label + " shines, but paths meet its light only by chance, which is grain; they look for balls, rectangles, discs, blocks with sharp edges and meshes of one material that shine by themselves");
            }
        }
    }

    /** The points of a light that reach farthest: it is within a body if all of these are, or nearly so. */
    private static Stream<Vec3> extent(PlacedLight light) {
        if (light instanceof AreaLight area && area.form() instanceof AreaLight.Size size) {
            return Stream.of(-0.5, 0.5).flatMap(x -> Stream.of(-0.5, 0.5).map(y -> new Vec3(x * size.width(), y * size.height(), 0))).map(area.placement().toParent()::point);
        } else if (light instanceof AreaLight area && area.form() instanceof AreaLight.Radius disc) {
            return Stream.of(Vec3.X, Vec3.Y).flatMap(way -> around(Vec3.ZERO, way.times(disc.radius()))).map(area.placement().toParent()::point);
        } else if (light instanceof SphereLight ball) {
            return Stream.of(Vec3.X, Vec3.Y, Vec3.Z).flatMap(way -> around(ball.position(), way.times(ball.radius())));
        }
        return Stream.of(light.position());
    }

    private static Stream<Vec3> around(Vec3 middle, Vec3 way) {
        return Stream.of(middle.minus(way), middle.plus(way));
    }

    private String name(int light) {
        String name = scene.lights().get(light).name();
        return name.isEmpty() ? "light #" + (light + 1) : "light \"" + name + "\"";
    }

    private void glass() {
        for (GlassContacts.Contact contact : GlassContacts.among(transparent, scene.camera().position())) {
            GlassContacts.Body first = contact.first();
            GlassContacts.Body second = contact.second();
            warnings.add(new SceneWarning(contact.overlap() ? "glass-overlaps" : "glass-touches", first.label(), Optional.of(first.place()), "", first.label()
                    + " and " + second.label() + (contact.overlap() ? " reach into each other" : " touch") + " near " + rounded(contact.point())
                    + ", with the refractive indices " + Numbers.text(first.index()) + " and " + Numbers.text(second.index())
                    + (contact.overlap() ? "; where both are, that of the one entered last counts" : "; there light goes straight from the one to the other")
                    + " (found by trying " + GlassContacts.RAYS + " rays)", !contact.overlap()));
        }
    }

    private static String rounded(Vec3 p) {
        return Numbers.text(new Vec3(rounded(p.x()), rounded(p.y()), rounded(p.z())));
    }

    private static double rounded(double x) {
        return x == 0 || Math.abs(x) < 1e-9 ? 0 : new BigDecimal(x).round(new MathContext(4)).doubleValue();
    }
}
