package cz.paprsek.cli.describe;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.query.Value;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import cz.paprsek.text.Numbers;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
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
        optional("tags", String.join(" ", scene.tags()));
        Described.elements(Scene.class).forEach(one -> optional(one.name(), text(one, one.value(scene)).strip().replaceAll("\\s+", " ")));
        if (scene.sky() instanceof Record sky) {
            optional("sky", text(Described.of(sky.getClass()).stream(), sky));
        }
        if (!scene.recipe().parameters().isEmpty()) {
            line("parameters", Integer.toString(scene.recipe().parameters().size()));
            scene.recipe().parameters().forEach(one -> item(one.name(), text(one)));
        }
        line("picture", settings.width() + "x" + settings.height() + ", "
                + text(Described.of(RenderSettings.class).stream().filter(one -> one.says().value() != Kind.PIXELS), settings));
        if (scene.cameras().size() == 1 && scene.camera().name().isEmpty()) {
            line("camera", text(scene.camera()));
        } else {
            line("cameras", Integer.toString(scene.cameras().size()));
            scene.cameras().forEach(camera -> item(camera.name(), text(camera)));
        }
        line("lights", Integer.toString(scene.lights().size()));
        for (Light light : scene.lights()) {
            item(light.name(), light.kind() + ": " + text(Described.inline(light.getClass()).stream(), light));
        }
        line("materials", Integer.toString(scene.materials().size()));
        scene.materials().forEach((name, material) -> item(name, text(material)));
        ReadyUses.of(scene).forEach((name, material) -> item(name, text(material) + " (ready)"));
        if (!scene.animations().isEmpty()) {
            line("animations", Integer.toString(scene.animations().size()));
            scene.animations().forEach(one -> item(one.target(), text(one)));
        }
    }

    private static String text(Animation one) {
        double first = one.keys().get(0).t();
        double last = one.keys().get(one.keys().size() - 1).t();
        return one.attribute() + ", " + one.keys().size() + (one.keys().size() == 1 ? " key" : " keys") + ", t " + Numbers.text(first) + " to " + Numbers.text(last);
    }

    /** Its value, what that is made of, and what it may be. */
    private static String text(Recipe.Parameter one) {
        String made = one.formula().equals(one.value()) ? "" : " = " + one.formula();
        return one.value() + made + bound(", from ", one.least()) + bound(one.least().isPresent() ? " to " : ", at most ", one.most()) + bound(", in steps of ", one.step());
    }

    private static String bound(String words, OptionalDouble number) {
        return number.isPresent() ? words + Numbers.text(number.getAsDouble()) : "";
    }

    /** What counts of attributes, each with its name; a share of nothing, a usual word and a pinhole are not worth one. */
    private static String text(Stream<Described> attributes, Object record) {
        return attributes.filter(one -> one.says().value() != Kind.NAME).flatMap(one -> named(one, record).stream()).collect(Collectors.joining(", "));
    }

    private static Optional<String> named(Described one, Object record) {
        return one.inForce(record).map(value -> text(one, value)).filter(value -> !isNothing(one, value)).map(value -> one.name() + " " + value);
    }

    private static boolean isNothing(Described one, String value) {
        return value.equals(one.says().otherwise()) && (one.says().value() == Kind.WORD || Set.of("0", "false").contains(value));
    }

    private static String text(Described one, Object value) {
        return one.says().value() == Kind.WORD ? Described.word(value)
                : value instanceof double[] samples && one.says().value() == Kind.SAMPLES ? Numbers.text(samples[0]) + (samples[1] > 0 ? ".." + Numbers.text(samples[1]) : "")
                : value instanceof Rgb color ? text(color)
                : value instanceof Vec3 vector ? Numbers.text(vector)
                : value instanceof double[] pair ? Numbers.text(pair[0]) + " " + Numbers.text(pair[1])
                : value instanceof Number number ? Numbers.text(number.doubleValue())
                : value.toString();
    }

    private void objects(SceneSummary summary) {
        int operands = summary.operands();
        line("objects", summary.scene().objects().size() + (operands > 0 ? ", with " + operands + (operands == 1 ? " operand" : " operands") : ""));
        summary.kinds().forEach((kind, count) -> item(kind, count.operands() == 0 ? Integer.toString(count.objects())
                : count.objects() + " and " + count.operands() + (count.operands() == 1 ? " operand" : " operands")));
        summary.meshes().forEach(mesh -> item(mesh.file(), ModelSummary.line(mesh)));
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
        return text(Described.inline(Camera.class).stream(), camera);
    }

    static String text(Rgb color) {
        return Numbers.text(color.red()) + " " + Numbers.text(color.green()) + " " + Numbers.text(color.blue());
    }

    private static String text(Material material) {
        String color = material.pattern() instanceof Pattern.Plain plain ? text(plain.color())
                : material.pattern().kind();
        return "color " + color + ", " + Described.of(Material.class).stream().flatMap(one -> material.byPattern(one.name())
                .map(share -> one.name() + " " + Value.Range.of(share).text()).or(() -> named(one, material)).stream()).collect(Collectors.joining(", "));
    }
}
