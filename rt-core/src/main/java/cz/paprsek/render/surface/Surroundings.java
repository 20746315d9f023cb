package cz.paprsek.render.surface;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import java.util.Arrays;

/** Scratch of one worker: finds the solids that rays start in. Nothing is allocated once it is made and has seen as much as there is to see. */
public final class Surroundings {
    private final World world;
    private final Vec3 camera;
    private final Ray ray = new Ray(new Spans());
    private final Spans ahead = new Spans();
    private final Bodies.Finder gatherer;
    /** The first parts of the solids that the point at hand is in. */
    private int[] inside = new int[8];
    private int size;
    /** Where rays start, and whether no solid that has an end reaches there. */
    private Bounds origins = Bounds.EMPTY;
    private boolean isFree;

    public Surroundings(World world) {
        this.world = world;
        this.camera = world.scene().camera().position();
        this.gatherer = world.bodies().newGatherer(ahead);
    }

    /** Makes ready for rays that start within a box: mostly the very one of the time before, and looking at it once more does no harm. */
    @SuppressWarnings("ReferenceEquality")
    public void from(Bounds box) {
        if (box != origins) {
            origins = box;
            isFree = world.bodies().areFree(box);
        }
    }

    /** Puts a ray into the media around the point it starts from. */
    public void enter(Ray started, Media media) {
        if (started.ox == camera.x() && started.oy == camera.y() && started.oz == camera.z()) {
            enter(world.aroundCamera(), world.aroundCamera().length, media);
        } else {
            look(started.ox, started.oy, started.oz, isFree);
            enter(inside, size, media);
        }
    }

    /** The first part of every solid that a point is in: the opaque ones, then the transparent ones, the largest first, as if entered from outside. */
    int[] around(Vec3 point) {
        look(point.x(), point.y(), point.z(), false);
        return Arrays.copyOf(inside, size);
    }

    private void enter(int[] around, int count, Media media) {
        media.clear();
        for (int i = 0; i < count; i++) {
            int object = world.parts().object(around[i]);
            if (world.isOpaque(object)) {
                media.surround(object);
            } else {
                Finish finish = world.parts().finish(around[i]);
                media.enter(object, finish.isThin ? media.refractiveIndex() : finish.refractiveIndex);
            }
        }
    }

    /** A solid whose surface is met an odd number of times on the way out has the point inside. */
    private void look(double x, double y, double z, boolean onlyEndless) {
        size = 0;
        ray.start(x, y, z, 1, 0, 0);
        ahead.release(0);
        if (!onlyEndless) {
            world.bodies().crossings(ray, gatherer);
        }
        for (int i = 0; i < ahead.size(); i++) {
            int object = world.parts().object(ahead.part(i));
            if (world.isSolid(object) && !remove(object)) {
                add(world.parts().firstOfObject(ahead.part(i)));
            }
        }
        for (int part : world.endless()) {
            int object = world.parts().object(part);
            remove(object);
            if (((Volume) world.surface(object)).holdsOrigin(ray)) {
                add(part);
            }
        }
        // By insertion: there are few.
        for (int i = 1; i < size; i++) {
            int part = inside[i];
            int at = i;
            for (; at > 0 && comesBefore(part, inside[at - 1]); at--) {
                inside[at] = inside[at - 1];
            }
            inside[at] = part;
        }
    }

    private boolean comesBefore(int part, int other) {
        int object = world.parts().object(part);
        int otherObject = world.parts().object(other);
        if (world.isOpaque(object) != world.isOpaque(otherObject)) {
            return world.isOpaque(object);
        }
        int bySize = Double.compare(world.surface(otherObject).bounds().volume(), world.surface(object).bounds().volume());
        return bySize != 0 ? bySize < 0 : part < other;
    }

    private void add(int part) {
        if (size == inside.length) {
            inside = Arrays.copyOf(inside, 2 * size);
        }
        inside[size++] = part;
    }

    /** Takes a solid out; whether it was in. */
    private boolean remove(int object) {
        for (int i = 0; i < size; i++) {
            if (world.parts().object(inside[i]) == object) {
                inside[i] = inside[--size];
                return true;
            }
        }
        return false;
    }
}
