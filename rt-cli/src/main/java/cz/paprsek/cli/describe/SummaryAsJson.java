package cz.paprsek.cli.describe;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Kind;
import cz.paprsek.io.Json;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;

/** A summary for scripts; colours are sRGB 0–255, as in scene files. */
public final class SummaryAsJson {
    private SummaryAsJson() {}

    public static Json of(String file, SceneSummary summary) {
        Scene scene = summary.scene();
        Json kinds = new Json();
        summary.kinds().forEach((kind, count) -> kinds.with(kind,
                new Json().with("objects", count.objects()).with("operands", count.operands())));
        Json json = new Json()
                .with("file", file)
                .with("name", scene.name())
                .with("description", scene.description())
                .withTexts("tags", scene.tags())
                .with("render", of(scene.settings()))
                .with("camera", of(scene.camera()))
                .with("cameras", scene.cameras().stream().map(SummaryAsJson::of).toList())
                .with("background", vector(scene.background()))
                .with("ambient", vector(scene.ambient()))
                .with("lights", scene.lights().stream().map(SummaryAsJson::of).toList())
                .with("materials", scene.materials().entrySet().stream().map(entry -> of(entry.getKey(), entry.getValue())).toList())
                .with("ready-materials", ReadyUses.of(scene).entrySet().stream().map(entry -> of(entry.getKey(), entry.getValue())).toList())
                .with("objects", scene.objects().size())
                .with("kinds", kinds)
                .with("unbounded", summary.unbounded());
        return summary.bounds().isEmpty() ? json : json.with("bounds", of(summary.bounds()));
    }

    private static Json of(RenderSettings settings) {
        Json json = new Json().with("width", settings.width()).with("height", settings.height()).with("max-depth", settings.maxDepth())
                .with("samples", settings.samples());
        if (settings.isAdaptive()) {
            json.with("most-samples", settings.mostSamples()).with("error", settings.error()).with("confidence", settings.confidence());
        }
        return json.with("filter", settings.filter().toString());
    }

    private static Json of(Camera camera) {
        Json json = new Json().with("name", camera.name()).with("projection", camera.lens().projection()).with("position", camera.position()).with("direction", camera.forward());
        if (camera.aim() instanceof Camera.Target target) {
            json.with("target", target.point());
        }
        json.with("up", camera.upwards());
        Described.inline(Camera.class, Lens.class).stream().filter(one -> one.isOf(camera))
                .forEach(one -> one.inForce(camera).ifPresent(value -> json.withValue(one.name(), value)));
        return json;
    }

    private static Json of(Light light) {
        Json json = new Json().with("name", light.name()).with("kind", light.kind());
        Described.inline(light.getClass()).stream().filter(one -> one.isOf(light) && one.says().value() != Kind.NAME)
                .forEach(one -> one.inForce(light).ifPresent(value -> with(json, one.name(), value)));
        return json;
    }

    private static void with(Json json, String name, Object value) {
        if (value instanceof Rgb color) {
            json.with(name, vector(color));
        } else {
            json.withValue(name, value);
        }
    }

    private static Json of(String name, Material material) {
        Json json = new Json().with("name", name);
        if (material.pattern() instanceof Pattern.Plain plain) {
            json.with("color", vector(plain.color()));
        } else {
            json.with("pattern", material.pattern().kind());
        }
        Described.of(Material.class).forEach(one -> one.inForce(material).ifPresent(value -> json.withValue(one.name(), value)));
        return json;
    }

    private static Json of(Bounds box) {
        return new Json().with("min", new Vec3(box.minX(), box.minY(), box.minZ())).with("max", new Vec3(box.maxX(), box.maxY(), box.maxZ()));
    }

    private static Vec3 vector(Rgb color) {
        return new Vec3(color.red(), color.green(), color.blue());
    }
}
