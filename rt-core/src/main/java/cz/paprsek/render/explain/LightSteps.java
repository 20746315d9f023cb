package cz.paprsek.render.explain;

import cz.paprsek.material.Material;
import cz.paprsek.render.explain.LightTerm.Obstacle;
import cz.paprsek.render.explain.Step.Topic;
import java.util.List;
import java.util.stream.Collectors;

/** Writes what one light adds at a point as part of a worked exercise. */
record LightSteps(Encounter met, LightTerm term, List<Step> steps) {

    void write() {
        step("light " + term.name(), "L, towards " + Figures.of(term.position()), "", Figures.of(term.direction()));
        step("", "N·L", Figures.of(met.place().towardsViewer()) + "·" + Figures.of(term.direction()), Figures.of(term.facing()));
        if (!term.isFacing()) {
            steps.add(Step.saying(Topic.SHADOW, "", "turned away from the light: nothing"));
            return;
        }
        term.obstacles().forEach(this::obstacle);
        steps.add(new Step(Topic.SHADOW, "", "V", term.obstacles().size() < 2 ? ""
                : term.obstacles().stream().map(o -> Figures.of(o.transparency())).collect(Collectors.joining("·")),
                Figures.of(term.visibility()) + (term.obstacles().isEmpty() ? ", nothing is in the way" : term.visibility() > 0 ? "" : ": in shadow")));
        if (term.visibility() > 0) {
            shine();
        }
    }

    private void obstacle(Obstacle obstacle) {
        boolean lets = obstacle.transparency() > 0;
        steps.add(Step.saying(Topic.SHADOW, "", (lets ? "through " : "blocked by ") + obstacle.surface() + " at " + Figures.of(obstacle.distance())
                + (lets ? ", kT " + Figures.of(obstacle.transparency()) : "")));
    }

    private void shine() {
        Material material = met.material();
        step("", "diffuse D = kD·N·L", Figures.of(material.diffusion()) + "·" + Figures.of(term.facing()), Figures.of(term.diffuse()));
        if (material.specular() > 0) {
            step("", "R·L", Figures.of(met.place().mirrored()) + "·" + Figures.of(term.direction()), Figures.of(term.alignment()));
            step("", "highlight S = kS·max(0, R·L)ⁿ",
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
