package cz.paprsek.render.explain.text;

import cz.paprsek.attribute.Described;
import cz.paprsek.io.Json;
import cz.paprsek.material.Material;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.Encounter.Refraction;
import cz.paprsek.render.explain.Encounter.Split;
import cz.paprsek.render.explain.LightTerm;
import cz.paprsek.render.explain.LightTerm.ShadowRay;
import cz.paprsek.render.explain.LightTerm.ShadowRay.Obstacle;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.TracedRay.Absorption;
import cz.paprsek.render.explain.TracedRay.SeenLight;
import cz.paprsek.render.explain.TracedRay.Sight;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.words.CopyOf;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/** A pixel's tree as a JSON object, every number in full; colours are linear. */
public final class TreeJson {
    private TreeJson() {}

    @SuppressWarnings("exports") // Told as it is by its toString; what it is made of is for our own programs.
    public static Json of(Pixel pixel) {
        Json json = color(new Json().with("column", pixel.column()).with("row", pixel.row()), "light", pixel.light());
        if (pixel.isDeveloped()) {
            color(json.with("exposure", pixel.exposure()).with("tone", pixel.tone().toString()), "shown", pixel.developed());
        }
        return json.withNumbers("weights", pixel.weights().stream().mapToDouble(Double::doubleValue).toArray())
                .with("rays", IntStream.range(0, pixel.rays().size()).mapToObj(i -> of(pixel.rays().get(i)).withNumbers("in-pixel", pixel.places().get(i).x(), pixel.places().get(i).y())).toList());
    }

    /** A ray and all that it gives rise to. */
    @SuppressWarnings("exports") // Told as it is by its toString; what it is made of is for our own programs.
    public static Json of(TracedRay ray) {
        Json json = share(new Json()
                .with("kind", ray.kind().name().toLowerCase(Locale.ROOT))
                .with("level", ray.level()), "weight", ray.weight())
                .with("origin", ray.origin())
                .with("direction", ray.direction())
                .with("medium", new Json().with("name", ray.medium().solid().map(solid -> solid.part().label(solid.scene())).orElse(""))
                        .with("refractive-index", ray.medium().refractiveIndex()));
        ray.sight().ifPresent(sight -> json.with("lens", of(sight)));
        ray.absorbed().ifPresent(by -> json.with("absorption", of(by)));
        color(json, "light", ray.light());
        ray.seen().ifPresent(light -> json.with("seen", of(light)));
        ray.encounter().ifPresent(met -> json.with("hit", of(met)));
        return json;
    }

    private static Json of(Sight sight) {
        Json json = new Json().with("projection", sight.lens().projection()).with("blind", sight.isBlind()).withNumbers("at", sight.across(), sight.upwards());
        sight.focus().ifPresent(focus -> json.with("focus", focus));
        return json;
    }

    private static Json of(Encounter met) {
        Json json = of(met.place()).with("material", of(met.material()));
        if (!met.readings().isEmpty()) {
            json.with("readings", met.readings().stream().map(TreeJson::of).toList());
        }
        color(json, "color", met.color());
        color(json, "ambient-light", met.ambientLight());
        color(json, "ambient", met.ambient());
        if (!met.emitted().equals(LinearRgb.BLACK)) {
            color(json, "emitted", met.emitted());
        }
        json.with("lights", met.lights().stream().map(TreeJson::of).toList());
        met.refraction().ifPresent(bend -> json.with("refraction", of(bend)));
        met.split().ifPresent(split -> json.with("fresnel", of(split)));
        met.facet().ifPresent(facet -> json.with("facet", new Json().with("normal", facet.normal()).with("chance", facet.chance()).with("seen", facet.seen())));
        met.reflected().ifPresent(ray -> json.with("reflected", of(ray)));
        met.refracted().ifPresent(ray -> json.with("refracted", of(ray)));
        return json.with("cut-off", met.cutOff());
    }

    private static Json of(Encounter.Reading reading) {
        Json json = new Json().with("of", reading.of()).with("pattern", reading.pattern());
        reading.point().ifPresent(point -> color(json.with("file", point.file()).withNumbers("uv", point.u(), point.v())
                .with("column", point.column()).with("row", point.row()), "point", point.value()));
        return color(json, "found", reading.found());
    }

    private static Json of(Encounter.Place place) {
        Json json = surface(place);
        place.triangle().ifPresent(triangle -> json.with("triangle", new Json().with("number", triangle.number()).with("part", triangle.part()).with("shares", triangle.shares())));
        return json;
    }

    private static Json surface(Encounter.Place place) {
        return new Json()
                .with("surface", of(place.surface()))
                .with("face", place.face().text())
                .with("flipped", place.flipped())
                .with("from-inside", place.fromInside())
                .with("distance", place.distance())
                .with("point", place.point())
                .with("normal", place.normal())
                .with("normal-towards-viewer", place.towardsViewer())
                .withNumbers("uv", place.u(), place.v())
                .with("cosine", place.cosine())
                .with("angle-degrees", place.angleDegrees())
                .with("mirrored", place.mirrored());
    }

    private static Json of(InScene<? extends ScenePath> surface) {
        return surface.part() instanceof BodyAt body ? body(surface.scene(), body)
                : new Json().with("light", ((ScenePath.LightAt) surface.part()).index());
    }

    private static Json body(Scene scene, BodyAt at) {
        Json json = new Json()
                .withNumbers("path", at.numbers().stream().mapToDouble(Integer::doubleValue).toArray())
                .withTexts("names", at.way().map(step -> step.label(scene)).toList());
        List<Json> copies = at.way().flatMap(step -> CopyOf.of(scene, step).stream()).map(copy -> new Json().with("number", copy.number()).with("of", copy.count())).toList();
        return copies.isEmpty() ? json : json.with("copies", copies);
    }

    private static Json of(Material material) {
        Json json = new Json();
        Described.of(Material.class).forEach(one -> json.withValue(one.name(), one.value(material)));
        return json;
    }

    private static Json of(LightTerm term) {
        Json json = new Json()
                .with("light", term.light())
                .with("name", term.label());
        if (term.rays().size() > 1) {
            return color(json.with("shadow-rays", term.rays().stream().map(ray -> color(with(new Json(), ray), "added", ray.added())).toList()),
                    "added", term.added());
        }
        return color(with(json, term.ray()), "added", term.added());
    }

    private static Json with(Json json, ShadowRay ray) {
        ray.target().ifPresent(point -> json.with("position", point));
        color(json, "intensity", ray.intensity()).with("direction", ray.direction());
        // JSON has no number for a sun's.
        if (Double.isFinite(ray.distance())) {
            json.with("distance", ray.distance());
        }
        if (!ray.absorptions().isEmpty()) {
            color(json.with("absorptions", ray.absorptions().stream().map(TreeJson::of).toList()), "left", ray.left());
        }
        ray.strewn().ifPresent(by -> json.with("strewn", color(new Json().with("spread", by.spread()).with("seen", by.seen()).with("lit", by.lit()), "value", by.value())));
        return json
                .with("n-dot-l", ray.facing())
                .with("r-dot-l", ray.alignment())
                .with("visibility", ray.visibility())
                .with("obstacles", ray.obstacles().stream().map(TreeJson::of).toList())
                .with("diffuse", ray.diffuse())
                .with("highlight", ray.highlight());
    }

    private static Json of(Absorption by) {
        Json json = new Json().with("body", of(by.body()));
        // JSON has no number for a way without end.
        return color(Double.isFinite(by.length()) ? json.with("length", by.length()) : json, "left", by.left());
    }

    private static Json of(SeenLight light) {
        Json json = new Json().with("light", light.light()).with("name", light.label());
        return Double.isFinite(light.distance()) ? json.with("distance", light.distance()) : json;
    }

    private static Json of(Obstacle obstacle) {
        return new Json()
                .with("surface", of(obstacle.surface()))
                .with("distance", obstacle.distance())
                .with("transparency", obstacle.transparency());
    }

    private static Json of(Refraction bend) {
        return new Json()
                .with("n1", bend.from())
                .with("n2", bend.to())
                .with("angle-degrees", bend.angleBeforeDegrees())
                .with("angle-beyond-degrees", bend.angleBeyondDegrees())
                .with("critical-angle-degrees", bend.criticalAngleDegrees())
                .with("total", bend.isTotal());
    }

    private static Json of(Split split) {
        return share(new Json().with("n1", split.from()).with("n2", split.to()).with("cosine", split.cosine()).with("cosine-beyond", split.beyond()),
                "mirrored", split.mirrored());
    }

    /** One number if it is the same in all channels. */
    private static Json share(Json json, String name, LinearRgb share) {
        return share.isGrey() ? json.with(name, share.red()) : color(json, name, share);
    }

    static Json color(Json json, String name, LinearRgb light) {
        return json.withNumbers(name, light.red(), light.green(), light.blue());
    }
}
