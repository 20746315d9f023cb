package cz.paprsek.render.explain.text;

import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.Encounter.Refraction;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.text.Step.Topic;
import cz.paprsek.words.Words;
import java.util.List;

/** Writes what is mirrored and what shines through at a point as part of a worked exercise. */
record OpticsSteps(String name, Encounter met, Words words, List<Step> steps) {

    void write() {
        boolean isTotal = met.refraction().map(Refraction::isTotal).orElse(false);
        if (isTotal) {
            total(met.refraction().orElseThrow());
        }
        met.reflected().ifPresent(child -> {
            step(Topic.REFLECTION, isTotal ? "" : words.of("name.reflection"), "R = d + 2·cos θ₁·N", "d + " + Figures.of(2 * met.place().cosine()) + "·N",
                    Figures.of(child.direction()));
            weighted(Topic.REFLECTION, isTotal ? "(kR + kT)" : "kR", "R", child);
        });
        met.refracted().ifPresent(child -> {
            refracted(met.refraction().orElseThrow(), child);
            weighted(Topic.REFRACTION, "kT", "T", child);
        });
    }

    private void refracted(Refraction bend, TracedRay child) {
        double ratio = ratio(bend);
        ratio(Topic.REFRACTION, bend);
        step(Topic.REFRACTION, "", "sin θ₂ = η·sin θ₁", sine(bend), Figures.of(ratio * StrictMath.sin(Math.toRadians(bend.angleBeforeDegrees())))
                + ", θ₂ = " + Figures.degrees(bend.angleBeyondDegrees()));
        step(Topic.REFRACTION, "", "T = η·d + (η·cos θ₁ − cos θ₂)·N",
                Figures.of(ratio) + "·d + (" + Figures.of(ratio * bend.cosine()) + " − " + Figures.of(Math.sqrt(bend.radicand())) + ")·N",
                Figures.of(child.direction()));
    }

    private void total(Refraction bend) {
        ratio(Topic.REFLECTION, bend);
        double sine = ratio(bend) * StrictMath.sin(Math.toRadians(bend.angleBeforeDegrees()));
        step(Topic.REFLECTION, "", "sin θ₂ = η·sin θ₁", sine(bend), Figures.of(sine) + words.of("no-angle"));
        step(Topic.REFLECTION, "", words.of("total"), "arcsin " + Figures.of(1 / ratio(bend)),
                Figures.degrees(bend.criticalAngleDegrees()) + words.of("all-mirrored"));
    }

    private static double ratio(Refraction bend) {
        return bend.from() / bend.to();
    }

    private void ratio(Topic topic, Refraction bend) {
        step(topic, words.of("name.refraction"), "η = n₁/n₂", Figures.of(bend.from()) + " / " + Figures.of(bend.to()), Figures.of(ratio(bend)));
    }

    private static String sine(Refraction bend) {
        return Figures.of(ratio(bend)) + " · sin " + Figures.degrees(bend.angleBeforeDegrees());
    }

    private void weighted(Topic topic, String share, String letter, TracedRay child) {
        step(topic, "", share + " · " + words.of("name.light-of", name + letter), Figures.of(child.weight()) + "·" + Figures.of(child.light()),
                Figures.of(child.light().times(child.weight())));
    }

    private void step(Topic topic, String what, String formula, String numbers, String result) {
        steps.add(new Step(topic, what, formula, numbers, result));
    }
}
