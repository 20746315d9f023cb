package cz.paprsek.render;

import cz.paprsek.shape.Hit;
import cz.paprsek.shape.Ray;
import cz.paprsek.shape.Spans;

/** Scratch of one level of recursion: a ray, what it met, and the light it brings back. */
final class Level {
    final Ray ray;
    final Hit hit = new Hit();
    final Media media = new Media();
    /** Whether the ray goes on beyond the surface it starts from, rather than back to the side it was seen from. */
    boolean beyond;
    /** The colour of the surface at the hit, linear. */
    double colorRed;
    double colorGreen;
    double colorBlue;
    /** The light that the ray brings back, linear. */
    double red;
    double green;
    double blue;

    Level(Spans spans) {
        ray = new Ray(spans);
    }

    void light(double r, double g, double b) {
        red = r;
        green = g;
        blue = b;
    }

    void add(double r, double g, double b) {
        red += r;
        green += g;
        blue += b;
    }

    /** Adds another level's light times a weight. */
    void add(double weight, Level other) {
        add(weight * other.red, weight * other.green, weight * other.blue);
    }
}
