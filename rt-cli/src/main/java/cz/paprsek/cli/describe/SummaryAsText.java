package cz.paprsek.cli.describe;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.text.Numbers;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A summary for people: a heading and its value a line, what belongs to it indented below. */
public final class SummaryAsText {
    private final List<String> lines = new ArrayList<>();

    private SummaryAsText() {}

    public static List<String> lines(SceneSummary summary) {
        SummaryAsText text = new SummaryAsText();
        text.scene(summary.scene());
        text.objects(summary);
        return text.lines;
    }

    private void scene(Scene scene) {
        RenderSettings settings = scene.settings();
        optional("name", scene.name());
        optional("description", scene.description().strip().replaceAll("\\s+", " "));
        optional("tags", String.join(" ", scene.tags()));
        line("picture", settings.width() + "x" + settings.height() + ", max-depth " + settings.maxDepth() + ", "
                + rays(settings));
        if (scene.cameras().size() == 1 && scene.camera().name().isEmpty()) {
            line("camera", text(scene.camera()));
        } else {
            line("cameras", Integer.toString(scene.cameras().size()));
            scene.cameras().forEach(camera -> item(camera.name(), text(camera)));
        }
        line("background", text(scene.background()));
        line("ambient", text(scene.ambient()));
        line("lights", Integer.toString(scene.lights().size()));
        for (Light light : scene.lights()) {
            item(light.name(), light.kind() + ": " + text(light));
        }
        line("materials", Integer.toString(scene.materials().size()));
        scene.materials().forEach((name, material) -> item(name, text(material)));
        ReadyUses.of(scene).forEach((name, material) -> item(name, text(material) + " (ready)"));
    }

    private static String text(Light light) {
        return text(Described.inline(light.getClass()).stream().filter(one -> one.isOf(light) && one.says().value() != Kind.NAME), light);
    }

    /** What counts of attributes, each with its name. */
    private static String text(Stream<Described> attributes, Object record) {
        return attributes.flatMap(one -> one.inForce(record).map(value -> one.name() + " " + text(value)).stream()).collect(Collectors.joining(", "));
    }

    private static String text(Object value) {
        return value instanceof Rgb color ? text(color)
                : value instanceof Vec3 vector ? Numbers.text(vector)
                : value instanceof double[] pair ? Numbers.text(pair[0]) + " " + Numbers.text(pair[1])
                : value instanceof Number number ? Numbers.text(number.doubleValue())
                : value instanceof Enum<?> word ? Described.word(word)
                : value.toString();
    }

    private void objects(SceneSummary summary) {
        int operands = summary.operands();
        line("objects", summary.scene().objects().size() + (operands > 0 ? ", with " + operands + (operands == 1 ? " operand" : " operands") : ""));
        summary.kinds().forEach((kind, count) -> item(kind, count.operands() == 0 ? Integer.toString(count.objects())
                : count.objects() + " and " + count.operands() + (count.operands() == 1 ? " operand" : " operands")));
        Bounds box = summary.bounds();
        line("bounds", (box.isEmpty() ? "none"
                : Numbers.text(box.minX()) + " " + Numbers.text(box.minY()) + " " + Numbers.text(box.minZ()) + " to "
                        + Numbers.text(box.maxX()) + " " + Numbers.text(box.maxY()) + " " + Numbers.text(box.maxZ()))
                + (summary.unbounded() > 0 ? ", and " + summary.unbounded() + " without bounds" : ""));
    }

    private void optional(String heading, String value) {
        if (!value.isEmpty()) {
            line(heading, value);
        }
    }

    private void line(String heading, String value) {
        lines.add(String.format("  %-12s %s", heading, value));
    }

    private void item(String name, String value) {
        lines.add(String.format("    %-12s %s", name.isEmpty() ? "-" : name, value));
    }

    private static String text(Camera camera) {
        Lens lens = camera.lens();
        return (lens instanceof Lens.Perspective ? "" : lens.projection() + ", ") + "position " + Numbers.text(camera.position()) + ", " + aim(camera)
                + ", up " + Numbers.text(camera.upwards()) + lens(camera);
    }

    /** A pinhole is not worth a word. */
    private static String lens(Camera camera) {
        String text = text(Described.inline(Camera.class, Lens.class).stream()
                .filter(one -> one.isOf(camera) && !(one.name().equals("aperture") && one.number(camera) == 0)), camera);
        return text.isEmpty() ? "" : ", " + text;
    }

    private static String rays(RenderSettings settings) {
        String rays = settings.isAdaptive()
                ? settings.samples() + "x" + settings.samples() + " to " + settings.mostSamples() + "x" + settings.mostSamples() + " rays a pixel, error "
                        + Numbers.text(settings.error()) + " at confidence " + Numbers.text(settings.confidence())
                : settings.samples() == 1 ? "1 ray a pixel" : settings.samples() + "x" + settings.samples() + " rays a pixel";
        return settings.filter() == PixelFilter.BOX ? rays : rays + ", filter " + settings.filter();
    }

    private static String aim(Camera camera) {
        return camera.aim() instanceof Camera.Target target
                ? "target " + Numbers.text(target.point())
                : "direction " + Numbers.text(camera.forward());
    }

    static String text(Rgb color) {
        return Numbers.text(color.red()) + " " + Numbers.text(color.green()) + " " + Numbers.text(color.blue());
    }

    private static String text(Material material) {
        String color = material.pattern() instanceof Pattern.Plain plain ? text(plain.color())
                : material.pattern().kind();
        return "color " + color + ", " + text(Described.of(Material.class).stream(), material);
    }
}
