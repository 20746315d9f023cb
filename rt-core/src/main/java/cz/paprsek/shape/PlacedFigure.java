package cz.paprsek.shape;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;

/** A figure made in code, in the world. */
final class PlacedFigure extends Surface implements Part {
    private final int part;
    private final Made made;

    PlacedFigure(int part, Affine toWorld, CustomShape shape) {
        this.part = part;
        this.made = new Made(shape, toWorld);
    }

    @Override
    public Bounds bounds() {
        return made.bounds;
    }

    @Override
    public double cost() {
        return made.cost;
    }

    @Override
    public void nearest(Ray ray) {
        Line line = made.crossed(ray);
        int start = start(line, ray);
        for (int i = 0; i < line.crossings(); i++) {
            if (i != start && line.t(i) > ray.min && line.t(i) < ray.reach) {
                ray.accept(line.t(i), part, line.face(i));
            }
        }
    }

    @Override
    public boolean occludes(Ray ray) {
        Line line = made.crossed(ray);
        int start = start(line, ray);
        for (int i = 0; i < line.crossings(); i++) {
            if (i != start && line.t(i) > ray.contact && line.t(i) < ray.max) {
                return true;
            }
        }
        return false;
    }

    @Override
    public void crossings(Ray ray, Spans out) {
        Line line = made.crossed(ray);
        int start = start(line, ray);
        for (int i = 0; i < line.crossings(); i++) {
            if (i != start && line.t(i) > ray.min && line.t(i) < ray.max) {
                out.add(line.t(i), part, line.face(i));
            }
        }
    }

    /** Which crossing is where the ray starts, if it starts from this figure: the one nearest to that place. */
    private int start(Line line, Ray ray) {
        int start = -1;
        if (part == ray.left) {
            for (int i = 0; i < line.crossings(); i++) {
                if (start < 0 || Math.abs(line.t(i)) < Math.abs(line.t(start))) {
                    start = i;
                }
            }
        }
        return start;
    }

    @Override
    public void describe(int face, Hit hit) {
        made.describe(face, hit);
    }

    @Override
    public void map(int face, Hit hit) {
        made.map(face, hit);
    }
}
