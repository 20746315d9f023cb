package cz.paprsek.shape;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Affine;
import cz.paprsek.ray.Hit;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;

/** Registers parts in a list. */
final class TestParts implements Parts {
    final List<Part> all = new ArrayList<>();

    @Override
    public <P extends Part> P add(IntFunction<P> maker) {
        P part = maker.apply(all.size());
        all.add(part);
        return part;
    }

    @Override
    public Parts within(MaterialSource material, Affine toWorld) {
        return this;
    }

    /** The normal at a ray's hit, turned as CSG says. */
    Hit describe(Ray ray) {
        Hit hit = new Hit();
        hit.px = ray.ox + ray.max * ray.dx;
        hit.py = ray.oy + ray.max * ray.dy;
        hit.pz = ray.oz + ray.max * ray.dz;
        boolean flipped = ray.face < 0;
        all.get(ray.part).describe(flipped ? ~ray.face : ray.face, hit);
        if (flipped) {
            hit.turn();
        }
        return hit;
    }
}
