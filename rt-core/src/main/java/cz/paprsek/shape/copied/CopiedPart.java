package cz.paprsek.shape.copied;

import cz.paprsek.math.Affine;
import cz.paprsek.ray.Hit;
import cz.paprsek.shape.placed.Part;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** A part of a copy, answered for by that of its original. Scratch: becomes one after the other, so that none has to be kept. */
public final class CopiedPart implements Part {
    private @Nullable Copy copy;
    private @Nullable Part part;
    /** For copies within the original. */
    private @Nullable CopiedPart within;

    /** Becomes a part of a copy, by its place among those of the original. */
    Part become(Copy of, int place) {
        CopiedPart room = within;
        if (room == null && of.original().hasCopies()) {
            room = new CopiedPart();
            within = room;
        }
        copy = of;
        part = of.original().part(place, room == null ? this : room);
        return this;
    }

    private Part part() {
        return Objects.requireNonNull(part);
    }

    /** What is done in the space of the original with a hit that is in the world, whose point is put back. */
    private interface Asked {
        void in(Part part, int face, Hit hit);
    }

    private Affine ask(Asked what, int face, Hit hit) {
        Affine map = Objects.requireNonNull(copy).toOriginal();
        double x = hit.px;
        double y = hit.py;
        double z = hit.pz;
        hit.px = map.pointX(x, y, z);
        hit.py = map.pointY(x, y, z);
        hit.pz = map.pointZ(x, y, z);
        what.in(part(), face, hit);
        hit.px = x;
        hit.py = y;
        hit.pz = z;
        return map;
    }

    @Override
    public void describe(int face, Hit hit) {
        Affine map = ask(Part::describe, face, hit);
        hit.normalsFrom(map);
    }

    @Override
    public int ownFace(int face) {
        return part().ownFace(face);
    }

    @Override
    public Optional<Corners> corners(int face, Hit hit) {
        Affine map = Objects.requireNonNull(copy).toOriginal();
        Hit there = new Hit();
        there.px = map.pointX(hit.px, hit.py, hit.pz);
        there.py = map.pointY(hit.px, hit.py, hit.pz);
        there.pz = map.pointZ(hit.px, hit.py, hit.pz);
        return part().corners(face, there);
    }

    @Override
    public void tint(int face, Hit hit) {
        ask(Part::tint, face, hit);
    }

    @Override
    public void map(int face, Hit hit) {
        double x = hit.nx;
        double y = hit.ny;
        double z = hit.nz;
        hit.normalInto(Objects.requireNonNull(copy).toOriginal());
        Affine map = ask(Part::map, face, hit);
        hit.nx = x;
        hit.ny = y;
        hit.nz = z;
        hit.tangentFrom(map);
    }
}
