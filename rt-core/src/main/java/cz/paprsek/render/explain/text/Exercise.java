package cz.paprsek.render.explain.text;

import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.Encounter.Reading;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.TracedRay.SeenLight;
import cz.paprsek.render.explain.TracedRay.Sight;
import cz.paprsek.render.explain.text.Step.Topic;
import cz.paprsek.scene.Lens;
import cz.paprsek.words.Words;
import java.util.ArrayList;
import java.util.List;

/** Writes the light of one ray as a worked exercise. */
final class Exercise {
    private final String name;
    private final TracedRay ray;
    private final Words words;
    private final List<Step> steps = new ArrayList<>();

    Exercise(String name, TracedRay ray, Words words) {
        this.name = name;
        this.ray = ray;
        this.words = words;
    }

    List<Step> steps() {
        ray.sight().ifPresent(this::seen);
        if (ray.sight().map(Sight::isBlind).orElse(false)) {
            step(Topic.SUM, words.of("name.light-of", name), "", "", Figures.of(ray.light()));
            return steps;
        }
        step(Topic.RAY, words.of("name.ray"), "o", "", Figures.of(ray.origin()));
        step(Topic.RAY, "", "d", "", Figures.of(ray.direction()));
        say(Topic.RAY, words.of("name.medium"), ray.medium().solid().map(words::surface).orElse(words.of("outside-all"))
                + words.of("medium", Figures.of(ray.medium().refractiveIndex())));
        ray.encounter().ifPresentOrElse(this::met, this::missed);
        return steps;
    }

    /** How the camera's lens makes the ray. */
    private void seen(Sight sight) {
        String lens = words.of("name.lens");
        if (sight.isBlind()) {
            say(Topic.RAY, lens, words.of("outside-circle"));
        } else if (sight.focus().isPresent()) {
            step(Topic.RAY, lens, words.of("lens-point"), "", Figures.pair(sight.across(), sight.upwards()));
            step(Topic.RAY, "", words.of("focus-point"), "", Figures.of(sight.focus().get()));
        } else if (sight.lens() instanceof Lens.Orthographic) {
            step(Topic.RAY, lens, words.of("plane-point"), "", Figures.pair(sight.across(), sight.upwards()));
        } else if (sight.lens() instanceof Lens.Spherical) {
            step(Topic.RAY, lens, words.of("longitude-latitude"), "", Figures.degrees(sight.across()) + ", " + Figures.degrees(sight.upwards()));
        } else if (sight.lens() instanceof Lens.Fisheye fisheye) {
            double radius = Math.sqrt(sight.across() * sight.across() + sight.upwards() * sight.upwards());
            step(Topic.RAY, lens, words.of("circle-point"), "", Figures.pair(sight.across(), sight.upwards()) + ", ρ = " + Figures.of(radius));
            step(Topic.RAY, "", words.of("angle-to-view"), Figures.of(radius) + "·" + Figures.degrees(fisheye.angle()) + "/2",
                    Figures.degrees(radius * fisheye.angle() / 2));
        }
    }

    private void missed() {
        ray.seen().ifPresentOrElse(this::seen, () -> say(Topic.POINT, words.of("name.hits"), words.of("nothing")));
        ray.absorbed().ifPresent(by -> steps.add(Absorbing.step(Topic.SUM, by, words)));
        step(Topic.SUM, words.of("name.light-of", name), "", "", Figures.of(ray.light()));
    }

    private void seen(SeenLight light) {
        say(Topic.POINT, words.of("name.hits"), words.of("light", light.label()) + (light.counted() ? words.of("counted") : ""));
        if (Double.isFinite(light.distance())) {
            step(Topic.POINT, words.of("name.distance"), "t", "", Figures.of(light.distance()));
        }
    }

    private void met(Encounter met) {
        place(met.place(), met.material().pattern().isMapped());
        material(met.material());
        met.readings().forEach(this::read);
        step(Topic.POINT, words.of("name.color"), "C", "", Figures.of(met.color()));
        step(Topic.AMBIENT, words.of("name.ambient"), "A·C", Figures.of(met.ambientLight()) + "·" + Figures.of(met.color()), Figures.of(met.ambient()));
        if (!met.emitted().equals(LinearRgb.BLACK)) {
            Material material = met.material();
            step(Topic.AMBIENT, words.of("name.emission"), "E·" + words.of("strength"), Figures.of(LinearRgb.of(material.emission())) + "·"
                    + Figures.of(material.emissionStrength()), Figures.of(met.emitted()));
        }
        met.lights().forEach(term -> new LightSteps(met, term, words, steps).write());
        if (met.lights().isEmpty() && met.material().diffusion() == 0 && met.material().specular() == 0) {
            say(Topic.LIGHT, words.of("name.lights"), words.of("no-light-shows"));
        }
        new OpticsSteps(name, met, words, steps).write();
        if (met.cutOff()) {
            say(Topic.REFLECTION, words.of("name.depth"), words.of("cut-off", ray.level()));
        }
        new SumSteps(name, ray, met, words, steps).write();
    }

    private void read(Reading reading) {
        String kind = words.has("pattern." + reading.pattern()) ? words.of("pattern." + reading.pattern()) : reading.pattern();
        reading.point().ifPresentOrElse(
                point -> step(Topic.POINT, words.of("reading." + reading.of()), kind + " " + point.file(), "u, v = " + Figures.of(point.u()) + ", " + Figures.of(point.v()),
                        words.of("picture-point", point.column(), point.row(), Figures.of(point.value())) + ", " + Figures.of(reading.found())),
                () -> step(Topic.POINT, words.of("reading." + reading.of()), kind, "", Figures.of(reading.found())));
    }

    private void place(Encounter.Place place, boolean isMapped) {
        say(Topic.POINT, words.of("name.hits"), words.surface(place.surface()) + words.face(place.face())
                + (place.flipped() ? words.of("hole") : "") + words.of(place.fromInside() ? "from-inside" : "from-outside"));
        place.triangle().ifPresent(triangle -> step(Topic.POINT, words.of("name.triangle", triangle.number()) + (triangle.part().isEmpty() ? "" : " (" + triangle.part() + ")"), "a, b, c", "",
                Figures.of(triangle.shares())));
        step(Topic.POINT, words.of("name.distance"), "t", "", Figures.of(place.distance()));
        step(Topic.POINT, words.of("name.point"), "P = o + t·d",
                Figures.of(ray.origin()) + " + " + Figures.of(place.distance()) + "·" + Figures.of(ray.direction()), Figures.of(place.point()));
        if (isMapped) {
            step(Topic.POINT, words.of("name.figure"), "u, v", "", Figures.of(place.u()) + ", " + Figures.of(place.v()));
        }
        step(Topic.POINT, words.of("name.normal"), place.fromInside() ? words.of("turned") : "N", "", Figures.of(place.towardsViewer()));
        Vec3 own = place.fromInside() ? place.normal().negated() : place.normal();
        if (!own.equals(place.towardsViewer())) {
            step(Topic.POINT, "", words.of("own-normal"), "", Figures.of(own));
        }
        step(Topic.POINT, words.of("name.angle"), "cos θ₁ = −d·N", "−" + Figures.of(ray.direction()) + "·" + Figures.of(place.towardsViewer()),
                Figures.of(place.cosine()) + ", θ₁ = " + Figures.degrees(place.angleDegrees()));
    }

    private void material(Material material) {
        say(Topic.POINT, words.of("name.material"), "kD " + Figures.of(material.diffusion())
                + (material.specular() > 0 ? ", kS " + Figures.of(material.specular()) + ", n " + Figures.of(material.shininess()) : "")
                + (material.reflection() > 0 ? ", kR " + Figures.of(material.reflection()) : "")
                + (material.transparency() > 0
                        ? ", kT " + Figures.of(material.transparency()) + words.of("medium", Figures.of(material.refractiveIndex())) : "")
                + (material.fresnel() == Fresnel.FALSE ? "" : words.of(material.fresnel() == Fresnel.TRUE ? "as-glass" : "as-metal"))
                + (material.roughness() > 0 ? words.of("rough", Figures.of(material.roughness() * material.roughness())) : "") + (material.thin() ? words.of("thin") : ""));
    }

    private void say(Topic topic, String what, String words) {
        steps.add(Step.saying(topic, what, words));
    }

    private void step(Topic topic, String what, String formula, String numbers, String result) {
        steps.add(new Step(topic, what, formula, numbers, result));
    }
}
