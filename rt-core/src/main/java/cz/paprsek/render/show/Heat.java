package cz.paprsek.render.show;

import cz.paprsek.material.Rgb;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.render.mode.RenderMode.HeatScale;

/** Shows a number of each pixel: on a mode's scale of colours, or for programs as it is. */
record Heat(HeatScale scale, RenderMode mode, boolean numbers) {
    private static final double STEPS = 255;

    static Heat of(RenderMode mode, boolean numbers) {
        return new Heat(mode.scale().orElseThrow(), mode, numbers);
    }

    void show(double value, int x, int y, Film film) {
        if (numbers) {
            film.set(x, y, value, value, value);
        } else {
            Rgb color = mode != RenderMode.ERROR ? scale.color(value) : value < 0 ? HeatScale.UNTRUSTED : scale.color(STEPS * value);
            film.set(x, y, color.linearRed(), color.linearGreen(), color.linearBlue());
        }
    }
}
