package cz.paprsek.shape;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;

/** A solid made in code, in the world. */
final class PlacedSolid extends Volume implements Part {
    private final int part;
    private final Made made;

    PlacedSolid(int part, Affine toWorld, CustomSolid shape) {
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
    public void spans(Ray ray, Spans out) {
        Line line = made.crossed(ray);
        int count = line.crossings();
        int mark = out.size();
        for (int i = 0; i < count; i++) {
            if (i > 0 && !(line.t(i) >= line.t(i - 1))) {
                throw new IllegalStateException("a " + made.kind() + " says that a line crosses it at " + line.t(i) + " after " + line.t(i - 1)
                        + "; it must be in rising order");
            }
            out.add(line.t(i), part, line.face(i));
        }
        if (count % 2 != 0) {
            throw new IllegalStateException("a " + made.kind() + " says that a line crosses it " + count + " times; it must be left as often as it is entered");
        }
        if (part == ray.left) {
            out.leaveFrom(mark, ray.inwards);
        }
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
