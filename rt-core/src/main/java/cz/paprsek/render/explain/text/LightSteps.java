package cz.paprsek.render.explain.text;

import cz.paprsek.material.Material;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.LightTerm;
import cz.paprsek.render.explain.LightTerm.ShadowRay;
import cz.paprsek.render.explain.LightTerm.ShadowRay.Obstacle;
import cz.paprsek.render.explain.text.Step.Topic;
import cz.paprsek.words.Words;
import java.util.List;
import java.util.stream.Collectors;

/** Writes what one light adds at a point as part of a worked exercise. */
record LightSteps(Encounter met, LightTerm term, Words words, List<Step> steps) {

    void write() {
        if (term.rays().size() == 1) {
            alone(term.ray());
        } else {
            several();
        }
    }

    private void alone(ShadowRay ray) {
        step(words.of("name.light", term.label()), ray.target().map(point -> words.of("towards", Figures.of(point))).orElse("L"), "", Figures.of(ray.direction()));
        step("", "N·L", Figures.of(met.place().towardsViewer()) + "·" + Figures.of(ray.direction()), Figures.of(ray.facing()));
        if (!ray.isSent()) {
            steps.add(Step.saying(Topic.SHADOW, "", nothing(ray)));
            return;
        }
        ray.obstacles().forEach(this::obstacle);
        steps.add(new Step(Topic.SHADOW, "", "V", ray.obstacles().size() < 2 ? ""
                : ray.obstacles().stream().map(o -> Figures.of(o.transparency())).collect(Collectors.joining("·")),
                Figures.of(ray.visibility()) + (ray.obstacles().isEmpty() && ray.absorptions().isEmpty() ? words.of("free") : ray.visibility() > 0 ? "" : words.of("in-shadow"))));
        absorptions(ray);
        if (ray.visibility() > 0) {
            shine(ray);
        }
    }

    /** Why none of the light is looked for. */
    private String nothing(ShadowRay ray) {
        return words.of(ray.distance() == 0 ? "in-one-place" : ray.facing() > 0 ? "shines-elsewhere" : "turned-away");
    }

    /** What the substances on the way leave; of several, the product. */
    private void absorptions(ShadowRay ray) {
        ray.absorptions().forEach(one -> steps.add(Absorbing.step(Topic.SHADOW, one, words)));
        if (ray.absorptions().size() > 1) {
            steps.add(new Step(Topic.SHADOW, "", "τ", "", Figures.of(ray.left())));
        }
    }

    private void obstacle(Obstacle obstacle) {
        steps.add(Step.saying(Topic.SHADOW, "", words.of(obstacle.transparency() > 0 ? "through" : "blocked",
                words.surface(obstacle.surface()), Figures.of(obstacle.distance()), Figures.of(obstacle.transparency()))));
    }

    private void shine(ShadowRay ray) {
        Material material = met.material();
        ray.strewn().ifPresent(by -> step(words.of("name.strewn"), ray.facing() > 0 ? "M = π·kR·F·D·G₁·G₁'/(4·N·v)" : "M = π·f·|N·L|",
                "D = " + Figures.of(by.spread()) + ", G₁ = " + Figures.of(by.seen()) + ", G₁' = " + Figures.of(by.lit()), Figures.share(by.value())));
        step("", words.of("diffuse", "kD·N·L"), Figures.of(material.diffusion()) + "·" + Figures.of(ray.facing()), Figures.of(ray.diffuse()));
        if (material.specular() > 0) {
            step("", "R·L", Figures.of(met.place().mirrored()) + "·" + Figures.of(ray.direction()), Figures.of(ray.alignment()));
            step("", words.of("highlight", "kS·max(0, R·L)ⁿ"),
                    Figures.of(material.specular()) + "·" + (ray.alignment() > 0 ? Figures.power(ray.alignment(), material.shininess()) : "0"),
                    Figures.of(ray.highlight()));
        }
        step("", (ray.absorptions().isEmpty() ? "V·I" : "V·τ·I") + letters(ray), brings(ray), Figures.of(ray.added()));
    }

    private String letters(ShadowRay ray) {
        boolean isShiny = met.material().specular() > 0;
        return ray.strewn().isPresent() ? isShiny ? "·(D·C + S + M)" : "·(D·C + M)" : isShiny ? "·(D·C + S)" : "·D·C";
    }

    private String brings(ShadowRay ray) {
        return Figures.of(ray.visibility()) + "·" + (ray.absorptions().isEmpty() ? "" : Figures.share(ray.left()) + "·") + Figures.of(ray.intensity()) + "·"
                + (met.material().specular() > 0 || ray.strewn().isPresent() ? "(" + Figures.of(ray.diffuse()) + "·C"
                        + (met.material().specular() > 0 ? " + " + Figures.of(ray.highlight()) : "") + ray.strewn().map(by -> " + " + Figures.share(by.value())).orElse("") + ")"
                        : Figures.of(ray.diffuse()) + "·C");
    }

    /** A line for each shadow ray, and the mean. */
    private void several() {
        int count = term.rays().size();
        steps.add(Step.saying(Topic.LIGHT, words.of("name.light", term.label()), words.of("looked-for", count)));
        for (int i = 0; i < count; i++) {
            ShadowRay ray = term.rays().get(i);
            String name = words.of("towards", ray.target().map(Figures::of).orElseGet(() -> Figures.of(ray.direction())));
            if (!ray.isSent()) {
                steps.add(Step.saying(Topic.SHADOW, "", (i + 1) + ": " + name + ": " + nothing(ray)));
            } else if (ray.visibility() > 0) {
                ray.obstacles().forEach(this::obstacle);
                absorptions(ray);
                step("", (i + 1) + ": " + name, brings(ray), Figures.of(ray.added()));
            } else {
                Obstacle last = ray.obstacles().get(ray.obstacles().size() - 1);
                steps.add(Step.saying(Topic.SHADOW, "", (i + 1) + ": " + name + ": "
                        + words.of("blocked", words.surface(last.surface()), Figures.of(last.distance()), Figures.of(last.transparency()))));
            }
        }
        step("", words.of("mean"), "Σ / " + count, Figures.of(term.added()));
    }

    private void step(String name, String formula, String numbers, String result) {
        steps.add(new Step(Topic.LIGHT, name, formula, numbers, result));
    }
}
