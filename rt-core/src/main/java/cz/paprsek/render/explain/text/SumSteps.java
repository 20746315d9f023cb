package cz.paprsek.render.explain.text;

import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.text.Step.Topic;
import cz.paprsek.words.Words;
import java.util.List;

/** Writes the terms of a ray's light one below the other, and their sum, as the end of a worked exercise. */
record SumSteps(String name, TracedRay ray, Encounter met, Words words, List<Step> steps) {

    void write() {
        int before = steps.size();
        term(words.of("name.ambient"), met.ambient());
        term(words.of("name.emission"), met.emitted());
        met.lights().forEach(light -> term(words.of("name.light", light.label()), light.added()));
        met.reflected().ifPresent(child -> term(words.of("plus-mirrored", name + "R"), child.light().times(child.weight())));
        met.refracted().ifPresent(child -> term(words.of("plus-through", name + "T"), child.light().times(child.weight())));
        if (steps.size() == before + 1) {
            steps.remove(before);
        }
        ray.absorbed().ifPresent(by -> {
            LinearRgb sum = met.terms().stream().reduce(LinearRgb.BLACK, LinearRgb::plus);
            steps.add(new Step(Topic.SUM, words.of("sum"), "Σ", "", Figures.of(sum)));
            steps.add(Absorbing.step(Topic.SUM, by, words));
            steps.add(new Step(Topic.SUM, "", "τ·Σ", Figures.share(by.left()) + "·" + Figures.of(sum), Figures.of(ray.light())));
        });
        steps.add(new Step(Topic.SUM, words.of("name.light-of", name), "", "", Figures.of(ray.light())));
    }

    private void term(String what, LinearRgb light) {
        if (!light.equals(LinearRgb.BLACK)) {
            steps.add(new Step(Topic.SUM, "", "+ " + what, "", Figures.of(light)));
        }
    }
}
