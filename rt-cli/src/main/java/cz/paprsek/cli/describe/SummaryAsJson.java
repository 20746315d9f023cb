package cz.paprsek.cli.describe;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Kind;
import cz.paprsek.io.Json;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.query.Value;
import cz.paprsek.query.text.TableText;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import java.util.stream.Stream;

/** A summary for scripts; colours are sRGB 0–255, as in scene files. */
public final class SummaryAsJson {
    private SummaryAsJson() {}

    public static Json of(String file, SceneSummary summary) {
        Scene scene = summary.scene();
        Json kinds = new Json();
        summary.kinds().forEach((kind, count) -> kinds.with(kind,
                new Json().with("objects", count.objects()).with("operands", count.operands())));
        Json json = new Json().with("file", file).with("name", scene.name()).withTexts("tags", scene.tags());
        inForce(json, Described.elements(Scene.class).stream(), scene);
        if (scene.sky() instanceof Record sky && !scene.sky().equals(Scene.Sky.NONE)) {
            json.with("sky", inForce(new Json(), Described.of(sky.getClass()).stream(), sky));
        }
        if (!scene.recipe().parameters().isEmpty()) {
            json.with("parameters", scene.recipe().parameters().stream().map(SummaryAsJson::of).toList());
        }
        json
                .with("render", of(scene.settings()))
                .with("camera", of(scene.camera()))
                .with("cameras", scene.cameras().stream().map(SummaryAsJson::of).toList())
                .with("lights", scene.lights().stream().map(SummaryAsJson::of).toList())
                .with("materials", scene.materials().entrySet().stream().map(entry -> of(entry.getKey(), entry.getValue())).toList())
                .with("ready-materials", ReadyUses.of(scene).entrySet().stream().map(entry -> of(entry.getKey(), entry.getValue())).toList())
                .with("objects", scene.objects().size())
                .with("kinds", kinds)
                .with("unbounded", summary.unbounded());
        if (!summary.meshes().isEmpty()) {
            json.with("meshes", summary.meshes().stream().map(ModelSummary::json).toList());
        }
        if (!scene.animations().isEmpty()) {
            json.with("animations", scene.animations().stream().map(SummaryAsJson::of).toList());
        }
        return summary.bounds().isEmpty() ? json : json.with("bounds", of(summary.bounds()));
    }

    private static Json of(Animation one) {
        Json json = new Json().with("target", one.target()).with("attribute", one.attribute()).with("turn", Described.word(one.turn()));
        if (!one.path().isBlank()) {
            json.with("path", one.path());
        }
        return json.with("keys", one.keys().stream()
                .map(key -> new Json().with("t", key.t()).with("value", key.value()).with("ease", Described.word(key.ease()))).toList());
    }

    /** A value that is no number is a text. */
    private static Json of(Recipe.Parameter one) {
        Json json = new Json().with("name", one.name()).with("formula", one.formula());
        if (one.number().isPresent()) {
            json.with("value", one.number().getAsDouble());
        } else {
            json.with("value", one.value());
        }
        one.least().ifPresent(least -> json.with("min", least));
        one.most().ifPresent(most -> json.with("max", most));
        one.step().ifPresent(step -> json.with("step", step));
        return json;
    }

    private static Json of(RenderSettings settings) {
        return inForce(new Json(), Described.of(RenderSettings.class).stream().flatMap(one -> one.apart().stream()), settings);
    }

    private static Json of(Camera camera) {
        Json json = inForce(new Json(), Described.inline(Camera.class).stream(), camera);
        return camera.aim() instanceof Camera.Direction ? json : json.with("direction", camera.forward());
    }

    private static Json of(Light light) {
        Json json = new Json().with("name", light.name()).with("kind", light.kind());
        return inForce(json, Described.inline(light.getClass()).stream().filter(one -> one.says().value() != Kind.NAME), light);
    }

    /** What counts of attributes. */
    private static Json inForce(Json json, Stream<Described> attributes, Object record) {
        attributes.forEach(one -> one.inForce(record).ifPresent(value -> json.withValue(one.name(), value instanceof Rgb color ? vector(color) : one.says().value() == Kind.WORD ? Described.word(value) : value)));
        return json;
    }

    private static Json of(String name, Material material) {
        Json json = new Json().with("name", name);
        if (material.pattern() instanceof Pattern.Plain plain) {
            json.with("color", vector(plain.color()));
        } else {
            json.with("pattern", material.pattern().kind());
        }
        Described.of(Material.class).forEach(one -> material.byPattern(one.name()).ifPresentOrElse(
                share -> json.with(one.name(), TableText.json(Value.Range.of(share))), () -> inForce(json, Stream.of(one), material)));
        return json;
    }

    private static Json of(Bounds box) {
        return new Json().with("min", new Vec3(box.minX(), box.minY(), box.minZ())).with("max", new Vec3(box.maxX(), box.maxY(), box.maxZ()));
    }

    private static Vec3 vector(Rgb color) {
        return new Vec3(color.red(), color.green(), color.blue());
    }
}
