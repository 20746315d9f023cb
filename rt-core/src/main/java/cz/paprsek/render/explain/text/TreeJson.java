package cz.paprsek.render.explain.text;

import cz.paprsek.attribute.Described;
import cz.paprsek.io.Json;
import cz.paprsek.material.Material;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.LightTerm.Obstacle;
import cz.paprsek.render.explain.LightTerm;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.Refraction;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.Locale;

/** A pixel's tree as a JSON object, every number in full; colours are linear. */
public final class TreeJson {
    private TreeJson() {}

    @SuppressWarnings("exports") // Told as it is by its toString; what it is made of is for our own programs.
    public static Json of(Pixel pixel) {
        return color(new Json().with("column", pixel.column()).with("row", pixel.row()), "light", pixel.light())
                .with("rays", pixel.rays().stream().map(TreeJson::of).toList());
    }

    /** A ray and all that it gives rise to. */
    @SuppressWarnings("exports") // Told as it is by its toString; what it is made of is for our own programs.
    public static Json of(TracedRay ray) {
        Json json = new Json()
                .with("kind", ray.kind().name().toLowerCase(Locale.ROOT))
                .with("level", ray.level())
                .with("weight", ray.weight())
                .with("origin", ray.origin())
                .with("direction", ray.direction())
                .with("medium", new Json().with("name", ray.medium().solid().map(solid -> solid.part().label(solid.scene())).orElse(""))
                        .with("refractive-index", ray.medium().refractiveIndex()));
        color(json, "light", ray.light());
        ray.encounter().ifPresent(met -> json.with("hit", of(met)));
        return json;
    }

    private static Json of(Encounter met) {
        Json json = of(met.place()).with("material", of(met.material()));
        color(json, "color", met.color());
        color(json, "ambient-light", met.ambientLight());
        color(json, "ambient", met.ambient());
        json.with("lights", met.lights().stream().map(TreeJson::of).toList());
        met.refraction().ifPresent(bend -> json.with("refraction", of(bend)));
        met.reflected().ifPresent(ray -> json.with("reflected", of(ray)));
        met.refracted().ifPresent(ray -> json.with("refracted", of(ray)));
        return json.with("cut-off", met.cutOff());
    }

    private static Json of(Encounter.Place place) {
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

    private static Json of(InScene<BodyAt> surface) {
        return new Json()
                .withNumbers("path", surface.part().numbers().stream().mapToDouble(Integer::doubleValue).toArray())
                .withTexts("names", surface.part().way().map(step -> step.label(surface.scene())).toList());
    }

    private static Json of(Material material) {
        Json json = new Json();
        Described.of(Material.class).forEach(one -> json.with(one.name(), one.number(material)));
        return json;
    }

    private static Json of(LightTerm term) {
        Json json = new Json()
                .with("light", term.light())
                .with("name", term.label())
                .with("position", term.position());
        color(json, "intensity", term.intensity())
                .with("direction", term.direction())
                .with("distance", term.distance())
                .with("n-dot-l", term.facing())
                .with("r-dot-l", term.alignment())
                .with("visibility", term.visibility())
                .with("obstacles", term.obstacles().stream().map(TreeJson::of).toList())
                .with("diffuse", term.diffuse())
                .with("highlight", term.highlight());
        return color(json, "added", term.added());
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

    private static Json color(Json json, String name, LinearRgb light) {
        return json.withNumbers(name, light.red(), light.green(), light.blue());
    }
}
