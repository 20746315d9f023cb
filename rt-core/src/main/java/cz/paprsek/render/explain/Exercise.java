package cz.paprsek.render.explain;

import cz.paprsek.material.Material;
import cz.paprsek.render.explain.Step.Topic;
import java.util.ArrayList;
import java.util.List;

/** Writes the light of one ray as a worked exercise. */
final class Exercise {
    private final String name;
    private final TracedRay ray;
    private final List<Step> steps = new ArrayList<>();

    Exercise(String name, TracedRay ray) {
        this.name = name;
        this.ray = ray;
    }

    List<Step> steps() {
        step(Topic.RAY, "ray", "o", "", Figures.of(ray.origin()));
        step(Topic.RAY, "", "d", "", Figures.of(ray.direction()));
        say(Topic.RAY, "medium", (ray.medium().name().isEmpty() ? "outside of all solids" : ray.medium().name())
                + ", refractive index " + Figures.of(ray.medium().refractiveIndex()));
        ray.encounter().ifPresentOrElse(this::met, this::missed);
        return steps;
    }

    private void missed() {
        say(Topic.POINT, "hits", "nothing: the background");
        step(Topic.SUM, "light of " + name, "", "", Figures.of(ray.light()));
    }

    private void met(Encounter met) {
        place(met.place());
        material(met.material());
        step(Topic.POINT, "colour", "C", "", Figures.of(met.color()));
        step(Topic.AMBIENT, "ambient", "A·C", Figures.of(met.ambientLight()) + "·" + Figures.of(met.color()), Figures.of(met.ambient()));
        met.lights().forEach(term -> new LightSteps(met, term, steps).write());
        if (met.material().diffusion() == 0 && met.material().specular() == 0) {
            say(Topic.LIGHT, "lights", "kD = kS = 0: light that falls on it does not show");
        }
        new OpticsSteps(name, met, steps).write();
        if (met.cutOff()) {
            say(Topic.REFLECTION, "depth", "level " + ray.level() + " is the last: what would be mirrored or shine through is black");
        }
        new SumSteps(name, ray, met, steps).write();
    }

    private void place(Encounter.Place place) {
        say(Topic.POINT, "hits", place.surface() + (place.face().equals("surface") ? "" : ", " + place.face())
                + (place.flipped() ? ", the wall of a hole" : "") + (place.fromInside() ? ", from inside" : ", from outside"));
        step(Topic.POINT, "distance", "t", "", Figures.of(place.distance()));
        step(Topic.POINT, "point", "P = o + t·d",
                Figures.of(ray.origin()) + " + " + Figures.of(place.distance()) + "·" + Figures.of(ray.direction()), Figures.of(place.point()));
        if (place.u() != 0 || place.v() != 0) {
            step(Topic.POINT, "on the figure", "u, v", "", Figures.of(place.u()) + ", " + Figures.of(place.v()));
        }
        step(Topic.POINT, "normal", place.fromInside() ? "N, turned round" : "N", "", Figures.of(place.towardsViewer()));
        step(Topic.POINT, "angle", "cos θ₁ = −d·N", "−" + Figures.of(ray.direction()) + "·" + Figures.of(place.towardsViewer()),
                Figures.of(place.cosine()) + ", θ₁ = " + Figures.degrees(place.angleDegrees()));
    }

    private void material(Material material) {
        say(Topic.POINT, "material", "kD " + Figures.of(material.diffusion())
                + (material.specular() > 0 ? ", kS " + Figures.of(material.specular()) + ", n " + Figures.of(material.shininess()) : "")
                + (material.reflection() > 0 ? ", kR " + Figures.of(material.reflection()) : "")
                + (material.transparency() > 0
                        ? ", kT " + Figures.of(material.transparency()) + ", refractive index " + Figures.of(material.refractiveIndex()) : ""));
    }

    private void say(Topic topic, String what, String words) {
        steps.add(Step.saying(topic, what, words));
    }

    private void step(Topic topic, String what, String formula, String numbers, String result) {
        steps.add(new Step(topic, what, formula, numbers, result));
    }
}
