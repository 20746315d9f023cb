package cz.paprsek.render.explain.text;

import cz.paprsek.material.Material;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.LightTerm.Obstacle;
import cz.paprsek.render.explain.LightTerm;
import cz.paprsek.render.explain.text.Step.Topic;
import cz.paprsek.words.Words;
import java.util.List;
import java.util.stream.Collectors;

/** Writes what one light adds at a point as part of a worked exercise. */
record LightSteps(Encounter met, LightTerm term, Words words, List<Step> steps) {

    void write() {
        step(words.of("name.light", term.label()), words.of("towards", Figures.of(term.position())), "", Figures.of(term.direction()));
        step("", "N·L", Figures.of(met.place().towardsViewer()) + "·" + Figures.of(term.direction()), Figures.of(term.facing()));
        if (!term.isFacing()) {
            steps.add(Step.saying(Topic.SHADOW, "", words.of("turned-away")));
            return;
        }
        term.obstacles().forEach(this::obstacle);
        steps.add(new Step(Topic.SHADOW, "", "V", term.obstacles().size() < 2 ? ""
                : term.obstacles().stream().map(o -> Figures.of(o.transparency())).collect(Collectors.joining("·")),
                Figures.of(term.visibility()) + (term.obstacles().isEmpty() ? words.of("free") : term.visibility() > 0 ? "" : words.of("in-shadow"))));
        if (term.visibility() > 0) {
            shine();
        }
    }

    private void obstacle(Obstacle obstacle) {
        steps.add(Step.saying(Topic.SHADOW, "", words.of(obstacle.transparency() > 0 ? "through" : "blocked",
                words.surface(obstacle.surface()), Figures.of(obstacle.distance()), Figures.of(obstacle.transparency()))));
    }

    private void shine() {
        Material material = met.material();
        step("", words.of("diffuse", "kD·N·L"), Figures.of(material.diffusion()) + "·" + Figures.of(term.facing()), Figures.of(term.diffuse()));
        if (material.specular() > 0) {
            step("", "R·L", Figures.of(met.place().mirrored()) + "·" + Figures.of(term.direction()), Figures.of(term.alignment()));
            step("", words.of("highlight", "kS·max(0, R·L)ⁿ"),
                    Figures.of(material.specular()) + "·" + (term.alignment() > 0 ? Figures.power(term.alignment(), material.shininess()) : "0"),
                    Figures.of(term.highlight()));
        }
        step("", material.specular() > 0 ? "V·I·(D·C + S)" : "V·I·D·C", Figures.of(term.visibility()) + "·" + Figures.of(term.intensity()) + "·"
                + (material.specular() > 0 ? "(" + Figures.of(term.diffuse()) + "·C + " + Figures.of(term.highlight()) + ")" : Figures.of(term.diffuse()) + "·C"),
                Figures.of(term.added()));
    }

    private void step(String name, String formula, String numbers, String result) {
        steps.add(new Step(Topic.LIGHT, name, formula, numbers, result));
    }
}
