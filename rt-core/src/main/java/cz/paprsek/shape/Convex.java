package cz.paprsek.shape;

/** A primitive that every line meets in one stretch at most. */
abstract class Convex extends Volume implements Part {
    final int part;

    Convex(int part) {
        this.part = part;
    }

    /** Finds the stretch of the line inside and sets the ray's enter, leave and their faces; false if there is none. */
    abstract boolean clip(Ray ray);

    @Override
    public void spans(Ray ray, Spans out) {
        if (clip(ray) && ray.enter < ray.max && ray.leave > ray.min) {
            out.add(ray.enter, part, ray.enterFace);
            out.add(ray.leave, part, ray.leaveFace);
        }
    }

    @Override
    public void nearest(Ray ray) {
        if (!clip(ray)) {
            return;
        }
        if (ray.enter > ray.min) {
            if (ray.enter < ray.max) {
                ray.accept(ray.enter, part, ray.enterFace);
            }
        } else if (ray.leave > ray.min && ray.leave < ray.max) {
            ray.accept(ray.leave, part, ray.leaveFace);
        }
    }

    @Override
    public boolean occludes(Ray ray) {
        return clip(ray) && ((ray.enter > ray.min && ray.enter < ray.max) || (ray.leave > ray.min && ray.leave < ray.max));
    }

    /** Narrows the ray's stretch to [enter, leave]; whether anything is left. */
    static boolean narrow(Ray ray, double enter, int enterFace, double leave, int leaveFace) {
        if (enter > ray.enter) {
            ray.enter = enter;
            ray.enterFace = enterFace;
        }
        if (leave < ray.leave) {
            ray.leave = leave;
            ray.leaveFace = leaveFace;
        }
        return ray.enter < ray.leave;
    }
}
