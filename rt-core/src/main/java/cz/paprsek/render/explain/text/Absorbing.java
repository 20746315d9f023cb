package cz.paprsek.render.explain.text;

import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.TracedRay.Absorption;
import cz.paprsek.render.explain.text.Step.Topic;
import cz.paprsek.words.Words;

/** Writes what a substance leaves of light as a line of a worked exercise. */
final class Absorbing {
    private Absorbing() {}

    static Step step(Topic topic, Absorption by, Words words) {
        Material material = by.substance();
        Rgb color = material.attenuationColor();
        LinearRgb taken = new LinearRgb(1 - color.linearRed(), 1 - color.linearGreen(), 1 - color.linearBlue());
        return new Step(topic, words.of("name.absorption"), words.of("absorption", words.surface(by.body()), Figures.of(by.length())) + ": τ = exp(−(1 − c)·d/D)",
                "exp(−" + Figures.of(taken) + "·" + Figures.of(by.length()) + "/" + Figures.of(material.attenuationDistance()) + ")", Figures.of(by.left()));
    }
}
