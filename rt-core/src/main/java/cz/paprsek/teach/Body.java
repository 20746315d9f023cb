package cz.paprsek.teach;

import cz.paprsek.math.Bounds;
import cz.paprsek.teach.Primitive.Stretch;
import java.util.List;

/** An object of the scene, in the world. */
final class Body {
    final Thing thing;
    /** Whether it has an inside. */
    final boolean isSolid;
    /** Whether light gets into that. */
    final boolean isGlass;
    private final Bounds box;

    /** @param box around it: what a ray misses whose line misses the box */
    Body(Thing thing, boolean isSolid, boolean isGlass, Bounds box) {
        this.thing = thing;
        this.isSolid = isSolid;
        this.isGlass = isGlass;
        this.box = box;
    }

    /** Whether it may be in the way of a ray: nothing but time would be lost if this were always true. */
    boolean isNear(Ray ray) {
        Stretch inside = Stretch.ALL.between(ray.start().x(), ray.direction().x(), box.minX(), box.maxX(), 0)
                .between(ray.start().y(), ray.direction().y(), box.minY(), box.maxY(), 0).between(ray.start().z(), ray.direction().z(), box.minZ(), box.maxZ(), 0);
        return inside.enter() <= inside.leave() && inside.leave() >= ray.near();
    }

    /** What a ray's line can cross: a primitive, or solids put together. */
    interface Thing {
        /** Where the whole line of a ray crosses the surface, in order; a solid is entered and left in turn. */
        List<Crossing> crossings(Ray ray);
    }
}
