package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.contact.Contact;
import cz.paprsek.fx.model.edit.Alignment;
import cz.paprsek.fx.model.edit.Alignment.Line;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.fx.model.edit.Rounds;
import cz.paprsek.fx.model.edit.Structure;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** Moving, turning or scaling under way: by the mouse, or by what is typed, which goes first. */
final class Manipulation {
    private static final double SNAP_DEGREES = 15;
    private static final double SNAP_FACTOR = 0.1;
    /** How near something must come to be in line with another, pixels. */
    private static final double REACH = 7;

    private final Gesture gesture;
    /** What touches a side is in line with it, scene units. */
    private static final double SAME = 1e-6;

    private final Set<ScenePath> items;
    private final Handles handles;
    private final Optional<Axis> held;
    private final Alignment alignment;
    private final Bounds box;
    /** Made when something is pulled. */
    private @Nullable Contact contact;
    private TypedAmount typed = TypedAmount.NONE;
    private boolean copies;
    private Vec3 by = Vec3.ZERO;
    private double amount;
    private List<Line> guides = List.of();

    /** @param held the axis that is pulled; empty for the middle */
    Manipulation(Gesture gesture, Set<ScenePath> items, Handles handles, Optional<Axis> held) {
        this.gesture = gesture;
        this.items = items;
        this.handles = handles;
        this.held = held;
        this.alignment = Alignment.with(gesture.start(), items);
        this.box = Alignment.around(gesture.start(), items);
        this.amount = handles.mode() == Handles.Mode.SCALE ? 1 : 0;
    }

    /** The mouse went from one place to another. */
    void to(double x0, double y0, double x, double y, boolean snaps) {
        guides = List.of();
        switch (handles.mode()) {
            case MOVE -> by = moved(x0, y0, x, y, snaps);
            case TURN -> {
                double degrees = handles.turned(axis(), x0, y0, x, y);
                amount = Math.rint(degrees / (snaps ? SNAP_DEGREES : 0.5)) * (snaps ? SNAP_DEGREES : 0.5);
            }
            case SCALE -> {
                double factor = handles.factor(held, x0, y0, x, y);
                amount = snaps ? Math.max(SNAP_FACTOR, Rounds.toGrid(factor, SNAP_FACTOR)) : Math.rint(factor * 100) / 100;
            }
        }
        show();
    }

    private Vec3 moved(double x0, double y0, double x, double y, boolean snaps) {
        Optional<Vec3> way = held.isPresent() ? along(held.get(), x0, y0, x, y)
                : handles.onFloor(x0, y0).flatMap(from -> handles.onFloor(x, y).map(to -> to.minus(from)));
        if (way.isEmpty()) {
            return by;
        }
        List<Line> lines = new ArrayList<>();
        Vec3 result = Vec3.ZERO;
        double step = Rounds.step(handles.scale());
        for (Axis axis : held.map(List::of).orElse(List.of(Axis.X, Axis.Z))) {
            double own = axis.of(way.get());
            Optional<Line> line = snaps ? line(axis, own, REACH / handles.scale()) : Optional.empty();
            line.ifPresent(lines::add);
            double start = axis.of(handles.middle());
            double free = snaps ? Rounds.toGrid(start + own, step) - start : Rounds.toGrid(own, step / 20);
            result = result.plus(axis.times(line.map(Line::by).orElse(free)));
        }
        if (held.isEmpty() && snaps) {
            Vec3 hand = way.get();
            Vec3 chosen = result;
            Optional<Line> touch = contact().inPlane(Axis.X, Axis.Z, hand, chosen, reach(lines, Axis.X, hand), reach(lines, Axis.Z, hand));
            result = touch.map(line -> chosen.plus(line.axis().times(line.by() - line.axis().of(chosen)))).orElse(chosen);
            touch.ifPresent(line -> {
                lines.removeIf(old -> old.axis() == line.axis());
                lines.add(line);
            });
        }
        guides = lines;
        return result;
    }

    /** How near a contact must be to count for more than a line that has been found. */
    private double reach(List<Line> lines, Axis axis, Vec3 hand) {
        return lines.stream().filter(line -> line.axis() == axis).findFirst().map(line -> Math.abs(line.by() - axis.of(hand)) - SAME).orElse(REACH / handles.scale());
    }

    private Contact contact() {
        Contact known = contact == null ? Contact.with(gesture.start(), items) : contact;
        contact = known;
        return known;
    }

    /** Sides and middles of others, or what is pulled would touch, whichever is nearer. */
    private Optional<Line> line(Axis axis, double own, double reach) {
        Optional<Line> line = alignment.along(axis, box, own, reach);
        double nearer = line.map(found -> Math.abs(found.by() - own) - SAME).orElse(reach);
        if (held.isEmpty() || nearer <= 0) {
            return line;
        }
        return contact().along(axis, own, nearer).or(() -> line);
    }

    private Optional<Vec3> along(Axis axis, double x0, double y0, double x, double y) {
        double way = handles.along(axis, x, y) - handles.along(axis, x0, y0);
        return Double.isNaN(way) ? Optional.empty() : Optional.of(axis.times(way));
    }

    /** What is turned about, and moved along, if nothing has been named. */
    private Axis axis() {
        return typed.axis().or(() -> held).orElse(handles.mode() == Handles.Mode.TURN ? Axis.Y : Axis.X);
    }

    TypedAmount typed() {
        return typed;
    }

    void type(TypedAmount value) {
        typed = value;
        show();
    }

    /** Leaves what is moved where it is and moves a copy, or not any more. */
    void copyOrNot() {
        copies = !copies;
        show();
    }

    private void show() {
        gesture.previewState(state -> {
            EditorState from = copies ? Structure.duplicate(state, items, Vec3.ZERO) : state;
            return from.withScene(changed(from.scene(), copies ? from.selection() : items));
        });
    }

    private Scene changed(Scene scene, Collection<ScenePath> moving) {
        return switch (handles.mode()) {
            case MOVE -> Moves.translated(scene, moving, way());
            case TURN -> degrees() == 0 ? scene : Moves.rotated(scene, moving, handles.middle(), axis().times(degrees()));
            case SCALE -> factor() == 1 ? scene : Moves.scaled(scene, moving, handles.middle(), factors());
        };
    }

    private Vec3 way() {
        return typed.isNone() ? by : axis().times(typed.value().orElse(0));
    }

    private double degrees() {
        return typed.value().orElse(typed.isNone() ? amount : 0);
    }

    /** What is no size counts as none said. */
    private double factor() {
        double factor = typed.value().orElse(typed.isNone() ? amount : 1);
        return factor > 0 ? factor : 1;
    }

    private Vec3 factors() {
        double factor = factor();
        return typed.axis().or(() -> held).map(axis -> Vec3.ONE.plus(axis.times(factor - 1))).orElse(new Vec3(factor, factor, factor));
    }

    Gesture gesture() {
        return gesture;
    }

    /** Lines that it has come to, where it is. */
    List<Line> guides() {
        return typed.isNone() ? guides : List.of();
    }

    /** The middle of what is moved, where it is now. */
    Vec3 middle() {
        return handles.mode() == Handles.Mode.MOVE ? handles.middle().plus(way()) : handles.middle();
    }

    /** How far, how much or by how many degrees. */
    String figures(Locale locale) {
        if (!typed.isNone()) {
            String axis = typed.axis().map(Manipulation::letter).orElse("");
            String number = typed.text().isEmpty() ? "…" : locale.getLanguage().equals("cs") ? typed.text().replace('.', ',') : typed.text();
            return (axis + " " + number.replace('-', '−') + (handles.mode() == Handles.Mode.TURN ? "°" : "")).strip();
        }
        return switch (handles.mode()) {
            case MOVE -> held.map(axis -> letter(axis) + " " + number(locale, "%+.2f", axis.of(by)))
                    .orElseGet(() -> "x " + number(locale, "%+.2f", by.x()) + "   z " + number(locale, "%+.2f", by.z()));
            case TURN -> letter(axis()) + " " + number(locale, "%.1f°", amount);
            case SCALE -> (held.map(Manipulation::letter).orElse("") + " × " + number(locale, "%.2f", amount)).strip();
        };
    }

    private static String number(Locale locale, String format, double value) {
        return String.format(locale, format, Math.rint(value * 100) / 100 + 0.0).replace('-', '−');
    }

    private static String letter(Axis axis) {
        return axis.name().toLowerCase(Locale.ROOT);
    }
}
