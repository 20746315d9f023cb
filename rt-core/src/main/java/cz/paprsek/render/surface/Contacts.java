package cz.paprsek.render.surface;

import cz.paprsek.ray.Hit;
import cz.paprsek.shape.copied.CopiedPart;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;

/**
 * Decides what a ray meets of surfaces that lie in one place, where rounding alone would. Scratch of one worker.
 *
 * <ul>
 * <li>A solid is entered from outside and left from inside; whatever else rounding puts near the start of a ray is behind it.
 * <li>Where one transparent solid ends and another begins, that one is entered before this one is left, as if they overlapped by nothing: the
 * ray is bent once, from the one index to the other.
 * <li>What has been left in a place is entered there again only if that lies ahead, as behind a slit; else a pile of panes would never end.
 * <li>What else touches a transparent solid from outside is met when that has been left.
 * <li>Of all others the lowest part is met first. So a figure without an inside lies beyond all lower parts, and before all higher ones, which those of
 * transparent solids are: it lies on glass, never in it.
 * </ul>
 */
public final class Contacts {
    private static final int NONE = -1;

    private final World scene;
    private final PartTable parts;
    private final Bodies bodies;
    private final Bodies.Finder finder;
    private final Bodies.Finder gatherer;
    private final Spans spans;
    private final Ray stretch;
    private final Hit hit = new Hit();
    private final CopiedPart copied = new CopiedPart();

    public Contacts(World scene, Bodies.Finder finder, Spans spans) {
        this.scene = scene;
        this.parts = scene.parts();
        this.bodies = scene.bodies();
        this.finder = finder;
        this.gatherer = bodies.newGatherer(spans);
        this.spans = spans;
        this.stretch = new Ray(spans);
    }

    /** To be called when the level's ray has hit something that touches where it starts, or is inside of something: the hit may become another one. */
    public void settle(Level level) {
        Ray ray = level.ray;
        if (ray.max <= ray.contact) {
            stretch.within(ray, ray.min, ray.contact);
            bodies.crossings(stretch, gatherer);
            if (settleFirst(level, true)) {
                return;
            }
            ray.within(ray, ray.contact, Double.POSITIVE_INFINITY);
            bodies.nearest(ray, bodies.whole(), finder);
        }
        if (ray.part >= 0 && level.media.areAround()) {
            settleTie(level);
        }
    }

    private void settleTie(Level level) {
        Ray ray = level.ray;
        int object = parts.object(ray.part);
        double touch = ray.touch(ray.max);
        stretch.within(ray, Math.max(ray.min, ray.max - touch), ray.max + touch);
        if (!scene.isMedium(object)) {
            for (int i = 0; i < level.media.count(); i++) {
                scene.surface(level.media.object(i)).crossings(stretch, spans);
            }
            settleFirst(level, false);
        } else if (level.media.hold(object) && scene.mayTouchMedium(object)) {
            bodies.crossings(stretch, gatherer);
            settleFirst(level, false);
        }
    }

    /** Makes the first of the boundaries pushed the hit, if there is one that counts, and forgets them. */
    private boolean settleFirst(Level level, boolean atStart) {
        int first = NONE;
        for (int i = 0; i < spans.size(); i++) {
            if (counts(stretch, level.media, atStart, level.beyond, i) && (first == NONE || isBefore(level.media, i, first))) {
                first = i;
            }
        }
        boolean found = first != NONE && (atStart || rank(level.media, first) < 2);
        if (found) {
            level.ray.settle(Math.max(0, spans.t(first)), spans.part(first), spans.face(first));
        }
        spans.release(0);
        return found;
    }

    private boolean isBefore(Media media, int i, int j) {
        int order = rank(media, i) - rank(media, j);
        return order < 0 || (order == 0 && spans.part(i) < spans.part(j));
    }

    private int rank(Media media, int i) {
        int object = parts.object(spans.part(i));
        if (!scene.isMedium(object)) {
            return 2;
        }
        return media.hold(object) ? 1 : media.areAround() ? 0 : 2;
    }

    /**
     * Whether a ray meets a boundary that lies in one place with others.
     *
     * @param media around the ray
     * @param atStart whether that is the place where the ray starts
     * @param beyond whether the ray goes on beyond the surface it starts from
     * @param i of the boundaries pushed
     */
    public boolean counts(Ray ray, Media media, boolean atStart, boolean beyond, int i) {
        int part = spans.part(i);
        int object = parts.object(part);
        if (scene.isSolid(object)) {
            boolean entry = isEntry(ray, i);
            return entry != media.hold(object) && !(entry && atStart && beyond && spans.t(i) <= 0 && media.havePassed(object));
        }
        if (!atStart) {
            return true;
        }
        int around = parts.object(ray.left);
        if (beyond) {
            return part > ray.left || (scene.isMedium(around) && !media.hold(around));
        }
        return part < ray.left && !media.hold(around);
    }

    private boolean isEntry(Ray ray, int i) {
        hit.px = ray.ox + spans.t(i) * ray.dx;
        hit.py = ray.oy + spans.t(i) * ray.dy;
        hit.pz = ray.oz + spans.t(i) * ray.dz;
        boolean flipped = spans.face(i) < 0;
        parts.part(spans.part(i), copied).describe(flipped ? ~spans.face(i) : spans.face(i), hit);
        return ray.dx * hit.nx + ray.dy * hit.ny + ray.dz * hit.nz < 0 != flipped;
    }
}
