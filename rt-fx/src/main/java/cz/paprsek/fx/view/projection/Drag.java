package cz.paprsek.fx.view.projection;

import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.edit.Rounds;
import cz.paprsek.fx.model.edit.Structure;
import cz.paprsek.fx.view.section.SectionSkin;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.BiFunction;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** What a pressed mouse button does until it is released. */
interface Drag {
    /**
     * Keys held meanwhile.
     *
     * @param free Ctrl: no snapping
     * @param straight Shift: along one axis only, or alike in both
     */
    record Keys(boolean free, boolean straight) {}

    /** The mouse is at a point of the pane, pixels. */
    void to(double x, double y, Keys keys);

    /** The button is released. */
    void end();

    /** Escape: all as it was before. */
    void cancel();

    /** How far or how large by now, in words; empty for nothing to say. */
    default String figures(Locale locale) {
        return "";
    }

    /** Leaves what is placed as it is and places a copy, or not any more, from the next movement on; false if it is nothing that is copied. */
    default boolean copyOrNot() {
        return false;
    }

    /** Draws what helps meanwhile. */
    default void draw(GraphicsContext g) {}

    /** Lines across the pane that what is dragged has come to. */
    default List<Segment> guides() {
        return List.of();
    }

    /** Whether {@link #draw} may draw anywhere in the pane. */
    default boolean isWide() {
        return true;
    }

    /** One that changes the scene: what it does is seen meanwhile, kept at the end, and taken back by Escape. */
    abstract class Changing implements Drag {
        final Gesture gesture;
        final Axes axes;
        final Viewport view;
        private final boolean snaps;
        private final double startX;
        private final double startY;

        Changing(Gesture gesture, Axes axes, Viewport view, boolean snaps, double startX, double startY) {
            this.gesture = gesture;
            this.axes = axes;
            this.view = view;
            this.snaps = snaps;
            this.startX = startX;
            this.startY = startY;
        }

        /** How far the mouse is from where it was pressed, to the right, in scene units. */
        final double byU(double x) {
            return (x - startX) / view.scale();
        }

        /** Likewise upwards. */
        final double byV(double y) {
            return (startY - y) / view.scale();
        }

        final boolean snaps(Keys keys) {
            return snaps && !keys.free();
        }

        @Override
        public final void end() {
            gesture.commit();
        }

        @Override
        public final void cancel() {
            gesture.cancel();
        }
    }

    /** One that places items, or copies of them. */
    abstract class Placing extends Changing {
        final Set<ScenePath> items;
        private boolean copies;

        Placing(Gesture gesture, Set<ScenePath> items, Axes axes, Viewport view, boolean snaps, double startX, double startY) {
            super(gesture, axes, view, snaps, startX, startY);
            this.items = items;
        }

        /** Shows what becomes of the scene by changing the items, or their copies, which then are what is selected. */
        final void preview(BiFunction<Scene, Set<ScenePath>, Scene> change) {
            gesture.previewState(state -> {
                EditorState from = copies ? Structure.duplicate(state, items, Vec3.ZERO) : state;
                return from.withScene(change.apply(from.scene(), copies ? from.selection() : items));
            });
        }

        @Override
        public final boolean copyOrNot() {
            copies = !copies;
            return true;
        }
    }

    /** One that moves the plane that solids are cut by, across the line in which it is seen. The scene stays as it is. */
    final class Cutting implements Drag {
        private final SectionSkin skin;
        private final Axes axes;
        private final Viewport view;
        private final boolean snaps;
        /** From the mouse to the line. */
        private final double away;

        Cutting(SectionSkin skin, SectionSkin.Line line, Axes axes, Viewport view, boolean snaps, double startX, double startY) {
            this.skin = skin;
            this.axes = axes;
            this.view = view;
            this.snaps = snaps;
            away = line.place() - line.axis().of(axes.vector(view.u(startX), view.v(startY)));
            skin.take();
        }

        /** How far from a line a point of the pane is, pixels. */
        static double distance(SectionSkin.Line line, Axes axes, Viewport view, double x, double y) {
            return Math.abs(line.place() - line.axis().of(axes.vector(view.u(x), view.v(y)))) * view.scale();
        }

        /** A point of a line in the middle of the pane. */
        static Vec3 middle(SectionSkin.Line line, Axes axes, Viewport view) {
            Vec3 centre = axes.vector(view.centreU(), view.centreV());
            return centre.plus(line.axis().times(line.place() - line.axis().of(centre)));
        }

        /** Where a line is, in words. */
        static String figures(SectionSkin.Line line, Viewport view, Locale locale) {
            return line.axis().name().toLowerCase(Locale.ROOT) + " " + view.text(line.place(), locale);
        }

        @Override
        public void to(double x, double y, Keys keys) {
            skin.line(axes.along()).ifPresent(line -> {
                double place = away + line.axis().of(axes.vector(view.u(x), view.v(y)));
                skin.moveTo(snaps && !keys.free() ? Rounds.toGrid(place, Rounds.step(view.scale())) : place);
            });
        }

        @Override
        public void end() {
            skin.letGo();
        }

        @Override
        public void cancel() {
            skin.putBack();
        }

        @Override
        public String figures(Locale locale) {
            return skin.line(axes.along()).map(line -> figures(line, view, locale)).orElse("");
        }
    }

    /** Selects all that lies wholly within a rubber band. */
    final class Band implements Drag {
        private final EditorModel model;
        private final Picker picker;
        private final Viewport view;
        private final Set<ScenePath> before;
        private final Color color;
        private final double startX;
        private final double startY;
        private double x;
        private double y;

        /** @param before what was selected and stays so */
        Band(EditorModel model, Picker picker, Viewport view, Set<ScenePath> before, Color color, double startX, double startY) {
            this.model = model;
            this.picker = picker;
            this.view = view;
            this.before = before;
            this.color = color;
            this.startX = startX;
            this.startY = startY;
            this.x = startX;
            this.y = startY;
        }

        @Override
        public void to(double toX, double toY, Keys keys) {
            x = toX;
            y = toY;
            Set<ScenePath> selected = new LinkedHashSet<>(before);
            selected.addAll(picker.within(model.state(), Box.of(view.u(startX), view.v(startY), view.u(x), view.v(y))));
            model.select(selected);
        }

        @Override
        public void end() {}

        @Override
        public void cancel() {
            model.select(before);
        }

        @Override
        public void draw(GraphicsContext g) {
            g.setFill(color.deriveColor(0, 1, 1, 0.12));
            g.fillRect(Math.min(x, startX), Math.min(y, startY), Math.abs(x - startX), Math.abs(y - startY));
            g.setStroke(color);
            g.strokeRect(Math.min(x, startX) + 0.5, Math.min(y, startY) + 0.5, Math.abs(x - startX), Math.abs(y - startY));
        }
    }
}
