package cz.paprsek.fx.view.projection;

import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.contact.Contact;
import cz.paprsek.fx.model.edit.Arranging;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.ScenePath;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** Moves items in the plane of the projection: onto the grid, in line with others, until they touch others. */
final class MoveDrag extends Drag.Placing {
    private final Box box;
    private final double referenceU;
    private final double referenceV;
    private final Snapping snapping;
    private double guideU = Double.NaN;
    private double guideV = Double.NaN;
    private double byU;
    private double byV;
    /** Made when something is moved and snaps. */
    private @Nullable Contact contact;

    /**
     * @param box around the items
     * @param reference what is put on the grid: the position of a single item, a corner of several
     */
    MoveDrag(Gesture gesture, Set<ScenePath> items, Axes axes, Viewport view, Box box, Box reference, Snapping snapping, boolean snaps,
            double startX, double startY) {
        super(gesture, items, axes, view, snaps, startX, startY);
        this.box = box;
        this.referenceU = reference.minU();
        this.referenceV = reference.minV();
        this.snapping = snapping;
    }

    @Override
    public void to(double x, double y, Keys keys) {
        double du = byU(x);
        double dv = byV(y);
        boolean onlyV = keys.straight() && Math.abs(du) < Math.abs(dv);
        boolean onlyU = keys.straight() && !onlyV;
        guideU = Double.NaN;
        guideV = Double.NaN;
        byU = onlyV ? 0 : du;
        byV = onlyU ? 0 : dv;
        if (snaps(keys)) {
            Snapping.Move alongU = snapping.alongU(box, du, referenceU, view);
            Snapping.Move alongV = snapping.alongV(box, dv, referenceV, view);
            byU = onlyV ? 0 : alongU.by();
            byV = onlyU ? 0 : alongV.by();
            guideU = onlyV ? Double.NaN : alongU.guide();
            guideV = onlyU ? Double.NaN : alongV.guide();
            touch(axes.vector(du, dv), onlyV ? 0 : alongU.reach(du, view), onlyU ? 0 : alongV.reach(dv, view));
        }
        preview((scene, placed) -> Moves.translated(scene, placed, axes.vector(byU, byV)));
    }

    /** What bodies touch by their surfaces counts for more than a line that is farther away. */
    private void touch(Vec3 hand, double reachU, double reachV) {
        Contact known = contact == null ? Contact.with(gesture.start(), items) : contact;
        contact = known;
        known.inPlane(axis(axes.right()), axis(axes.up()), hand, axes.vector(byU, byV), reachU, reachV).ifPresent(line -> {
            Vec3 by = line.axis().times(line.by());
            Vec3 place = line.axis().times(line.place());
            if (line.axis() == axis(axes.right())) {
                byU = axes.u(by);
                guideU = axes.u(place);
            } else {
                byV = axes.v(by);
                guideV = axes.v(place);
            }
        });
    }

    private static Arranging.Axis axis(Axes.Axis axis) {
        return switch (axis) {
            case X -> Arranging.Axis.X;
            case Y -> Arranging.Axis.Y;
            case Z -> Arranging.Axis.Z;
        };
    }

    @Override
    public String figures(Locale locale) {
        return axes.right().letter() + " " + view.signed(axes.worldU(byU), locale) + "   "
                + axes.up().letter() + " " + view.signed(axes.worldV(byV), locale);
    }

    @Override
    public boolean isWide() {
        return false;
    }

    @Override
    public List<Segment> guides() {
        return Stream.of(new Segment(view.x(guideU), 0, view.x(guideU), view.height()), new Segment(0, view.y(guideV), view.width(), view.y(guideV)))
                .filter(line -> !Double.isNaN(line.x1() + line.y1())).toList();
    }
}
