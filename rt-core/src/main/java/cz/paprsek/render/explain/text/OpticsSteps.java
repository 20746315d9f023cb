package cz.paprsek.render.explain.text;

import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.Encounter.Facet;
import cz.paprsek.render.explain.Encounter.Refraction;
import cz.paprsek.render.explain.Encounter.Split;
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
        if (!isTotal) {
            met.split().filter(split -> met.material().fresnel() != Fresnel.FALSE).ifPresent(this::fresnel);
        }
        met.facet().ifPresent(this::facet);
        met.reflected().ifPresent(child -> {
            step(Topic.REFLECTION, isTotal ? "" : words.of("name.reflection"), "R = d + 2·cos θ₁·" + normal(), "d + " + Figures.of(2 * cosine()) + "·" + normal(),
                    Figures.of(child.direction()));
            weighted(Topic.REFLECTION, mirroredShare(isTotal) + rough(), "R", child);
        });
        met.refracted().ifPresent(child -> {
            met.refraction().ifPresent(bend -> refracted(bend, child));
            weighted(Topic.REFRACTION, (isGlass() ? "kT·(1 − kR·" + letter() + ")" : "kT") + rough(), "T", child);
        });
    }

    /** A rough surface's facet takes the place of the surface. */
    private void facet(Facet facet) {
        step(Topic.REFLECTION, words.of("name.facet"), "m", "", Figures.of(facet.normal()));
        step(Topic.REFLECTION, "", words.of("facet-chance"), "", Figures.of(facet.chance()));
        step(Topic.REFLECTION, "", words.of("facet-seen", "G₁"), "", Figures.of(facet.seen()));
    }

    private String normal() {
        return met.facet().isPresent() ? "m" : "N";
    }

    private double cosine() {
        return met.split().map(Split::cosine).orElse(met.place().cosine());
    }

    private String rough() {
        return met.facet().isPresent() ? "·G₁/p" : "";
    }

    private String mirroredShare(boolean isTotal) {
        if (isTotal) {
            return isGlass() ? "(kR + kT·(1 − kR))" : isMetal() ? "(kR·F + kT)" : "(kR + kT)";
        }
        return isGlass() || isMetal() ? "kR·" + letter() : "kR";
    }

    private boolean isMetal() {
        return met.material().fresnel() == Fresnel.METAL;
    }

    private boolean isGlass() {
        return met.material().fresnel() == Fresnel.TRUE;
    }

    private String letter() {
        return isPane() ? "F'" : "F";
    }

    /** Whether it mirrors on both sides. */
    private boolean isPane() {
        return isGlass() && met.refraction().isEmpty() && met.material().transparency() > 0;
    }

    /** How much is mirrored at this angle. */
    private void fresnel(Split split) {
        if (!isGlass()) {
            step(Topic.REFLECTION, words.of("name.fresnel"), "F = C + (1 − C)·(1 − cos θ₁)⁵",
                    Figures.of(met.color()) + " + (1 − C)·" + Figures.power(1 - split.cosine(), 5), Figures.of(split.mirrored()));
            return;
        }
        double n1 = split.from();
        double n2 = split.to();
        double c1 = split.cosine();
        double c2 = split.beyond();
        step(Topic.REFLECTION, words.of("name.fresnel"), words.of("beyond", "cos θ₂"), "√(1 − (" + Figures.of(n1) + " / " + Figures.of(n2) + ")²·(1 − " + Figures.of(c1) + "²))",
                Figures.of(c2));
        double s = amplitude(n1 * c1, n2 * c2);
        double p = amplitude(n1 * c2, n2 * c1);
        step(Topic.REFLECTION, "", "s = (n₁c₁ − n₂c₂)/(n₁c₁ + n₂c₂)", quotient(n1, c1, n2, c2), Figures.of(s));
        step(Topic.REFLECTION, "", "p = (n₁c₂ − n₂c₁)/(n₁c₂ + n₂c₁)", quotient(n1, c2, n2, c1), Figures.of(p));
        step(Topic.REFLECTION, "", "F = ½s² + ½p²", "½·" + Figures.power(s, 2) + " + ½·" + Figures.power(p, 2), Figures.of((s * s + p * p) / 2));
        if (isPane()) {
            step(Topic.REFLECTION, "", words.of("both-sides", "F' = 2F/(1 + F)"), "", Figures.share(split.mirrored()));
        }
    }

    private void refracted(Refraction bend, TracedRay child) {
        double ratio = ratio(bend);
        ratio(Topic.REFRACTION, bend);
        step(Topic.REFRACTION, "", "sin θ₂ = η·sin θ₁", sine(bend), Figures.of(ratio * StrictMath.sin(Math.toRadians(bend.angleBeforeDegrees())))
                + ", θ₂ = " + Figures.degrees(bend.angleBeyondDegrees()));
        step(Topic.REFRACTION, "", "T = η·d + (η·cos θ₁ − cos θ₂)·" + normal(),
                Figures.of(ratio) + "·d + (" + Figures.of(ratio * bend.cosine()) + " − " + Figures.of(Math.sqrt(bend.radicand())) + ")·" + normal(),
                Figures.of(child.direction()));
    }

    private void total(Refraction bend) {
        ratio(Topic.REFLECTION, bend);
        double sine = ratio(bend) * StrictMath.sin(Math.toRadians(bend.angleBeforeDegrees()));
        step(Topic.REFLECTION, "", "sin θ₂ = η·sin θ₁", sine(bend), Figures.of(sine) + words.of("no-angle"));
        step(Topic.REFLECTION, "", words.of("total"), "arcsin " + Figures.of(1 / ratio(bend)),
                Figures.degrees(bend.criticalAngleDegrees()) + words.of("all-mirrored"));
    }

    private static double amplitude(double first, double second) {
        return (first - second) / (first + second);
    }

    private static String quotient(double n1, double c1, double n2, double c2) {
        String first = Figures.of(n1) + "·" + Figures.of(c1);
        String second = Figures.of(n2) + "·" + Figures.of(c2);
        return "(" + first + " − " + second + ")/(" + first + " + " + second + ")";
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
        step(topic, "", share + " · " + words.of("name.light-of", name + letter), Figures.share(child.weight()) + "·" + Figures.of(child.light()),
                Figures.of(child.light().times(child.weight())));
    }

    private void step(Topic topic, String what, String formula, String numbers, String result) {
        steps.add(new Step(topic, what, formula, numbers, result));
    }
}
