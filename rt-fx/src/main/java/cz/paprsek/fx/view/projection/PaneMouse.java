package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.edit.LightMoves;
import cz.paprsek.fx.model.edit.Pivots;
import cz.paprsek.fx.view.command.NextFrame;
import cz.paprsek.fx.view.projection.Grips.Grip;
import cz.paprsek.fx.view.section.SectionSkin;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javafx.scene.Cursor;
import javafx.scene.control.ContextMenu;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import org.jspecify.annotations.Nullable;

/** What the mouse does in a projection. */
final class PaneMouse {
    /** How far the mouse goes before a click becomes a drag, pixels. */
    private static final double SLACK = 3;
    /** How near the mouse must come to what a light or camera is grabbed by, pixels. */
    private static final double GRIP = 8;
    /** How near it must come to the line of the plane that solids are cut by, pixels. */
    private static final double LINE = 4;
    private static final double ZOOM_PER_NOTCH = 1.15;

    private final ProjectionPane pane;
    private final EditorModel model;
    private final NextFrame next;
    private boolean spaceHeld;
    private double pressX;
    private double pressY;
    private double lastX;
    private double lastY;
    private List<ScenePath> pressedOn = List.of();
    private List<ScenePath> clickedOn = List.of();
    private boolean panning;
    private boolean pressed;
    private @Nullable Drag drag;
    private Drag.Keys keys = new Drag.Keys(false, false);

    PaneMouse(ProjectionPane pane) {
        this.pane = pane;
        this.model = pane.model();
        this.next = new NextFrame(pane, this::follow);
        pane.setOnMousePressed(this::pressed);
        pane.setOnMouseDragged(this::dragged);
        pane.setOnMouseReleased(this::released);
        pane.setOnMouseMoved(this::moved);
        pane.setOnMouseExited(event -> pane.setPointed(Optional.empty()));
        pane.setOnScroll(this::scrolled);
        pane.setOnZoom(event -> pane.show(pane.view().zoomed(event.getZoomFactor(), event.getX(), event.getY())));
        pane.addEventHandler(KeyEvent.KEY_PRESSED, this::keyPressed);
        pane.addEventHandler(KeyEvent.KEY_RELEASED, this::keyReleased);
    }

    private void pressed(MouseEvent event) {
        pane.requestFocus();
        pane.menu().ifPresent(ContextMenu::hide);
        event.consume();
        if (drag != null) {
            return;
        }
        if (event.getButton() == MouseButton.PRIMARY && pane.edits().pipette().isActive()) {
            List<ScenePath> under = pane.picker().at(model.state(), pane.view(), event.getX(), event.getY());
            pane.edits().pipette().take(Places.bodies(under).stream().findFirst());
            return;
        }
        pressX = event.getX();
        pressY = event.getY();
        lastX = pressX;
        lastY = pressY;
        panning = event.getButton() == MouseButton.MIDDLE || (event.getButton() == MouseButton.PRIMARY && spaceHeld);
        pressed = event.getButton() == MouseButton.PRIMARY && !spaceHeld;
        if (panning) {
            pane.setHoverCursor(Cursor.CLOSED_HAND);
        } else if (pressed) {
            pressedOn = pane.picker().at(model.state(), pane.view(), pressX, pressY);
        }
    }

    private void dragged(MouseEvent event) {
        event.consume();
        if (panning) {
            pane.show(pane.view().panned(event.getX() - lastX, event.getY() - lastY));
        }
        lastX = event.getX();
        lastY = event.getY();
        if (!pressed) {
            point();
            return;
        }
        if (drag == null && Math.hypot(lastX - pressX, lastY - pressY) > SLACK) {
            setDrag(begin(event));
        }
        keys = new Drag.Keys(event.isShortcutDown(), event.isShiftDown());
        next.ask();
    }

    private void released(MouseEvent event) {
        // A quick hand on a busy machine may be told of only here.
        dragged(event);
        next.now();
        boolean wasClick = pressed && drag == null;
        if (drag != null) {
            drag.end();
            setDrag(null);
        } else if (wasClick) {
            click(event);
        } else if (event.getButton() == MouseButton.SECONDARY) {
            showMenu(event);
        }
        panning = false;
        pressed = false;
        pane.setHoverCursor(Cursor.DEFAULT);
    }

    /** For what is under the mouse, unless that is selected already; for what is selected if nothing is. */
    private void showMenu(MouseEvent event) {
        List<ScenePath> under = pane.picker().at(model.state(), pane.view(), event.getX(), event.getY());
        if (!under.isEmpty() && under.stream().noneMatch(model.selection()::contains)) {
            model.select(under.get(0));
        }
        pane.menu().ifPresent(menu -> menu.show(pane, event.getScreenX(), event.getScreenY()));
    }

    private void click(MouseEvent event) {
        pane.section().ifPresent(SectionSkin::letGo);
        if (lineAt(pressX, pressY).isPresent()) {
            pane.section().ifPresent(SectionSkin::take);
            return;
        }
        boolean more = event.isShiftDown() || event.isShortcutDown();
        if (pressedOn.isEmpty()) {
            if (!more) {
                model.select();
            }
        } else if (more) {
            Set<ScenePath> selection = new LinkedHashSet<>(model.selection());
            if (!selection.remove(pressedOn.get(0))) {
                selection.add(pressedOn.get(0));
            }
            model.select(selection);
        } else {
            model.select(pressedOn.get(next()));
        }
        clickedOn = pressedOn;
    }

    /** The first thing under the mouse; if the last click was on the same things, the one after that selected. */
    private int next() {
        if (!clickedOn.equals(pressedOn) || model.selection().size() != 1) {
            return 0;
        }
        return (pressedOn.indexOf(model.selection().iterator().next()) + 1) % pressedOn.size();
    }

    private Drag begin(MouseEvent event) {
        Optional<Handle> handle = pane.handleAt(pressX, pressY);
        if (handle.isPresent()) {
            return begin(handle.get());
        }
        Optional<Grip> grip = gripAt(pressX, pressY);
        if (grip.isPresent()) {
            Label label = label(grip.get() instanceof Grip.Aim && !(grip.get().item() instanceof BodyAt) ? Edit.ROTATE : Edit.CHANGE, Set.of(grip.get().item()));
            return new GripDrag(model.begin(label), grip.get(), pane.axes(), pane.view(), pane.texts(), pane.snaps(), pressX, pressY);
        }
        Optional<SectionSkin.Line> line = lineAt(pressX, pressY);
        if (line.isPresent()) {
            return new Drag.Cutting(pane.section().orElseThrow(), line.get(), pane.axes(), pane.view(), pane.snaps(), pressX, pressY);
        }
        if (pressedOn.isEmpty()) {
            Set<ScenePath> before = event.isShiftDown() ? model.selection() : Set.of();
            return new Drag.Band(model, pane.picker(), pane.view(), before, pane.theme().palette().selected(), pressX, pressY);
        }
        if (pressedOn.stream().noneMatch(model.selection()::contains)) {
            model.select(pressedOn.get(0));
        }
        return beginMove();
    }

    private Drag beginMove() {
        Set<ScenePath> items = pane.movable();
        Box box = pane.figures().box(items);
        return new MoveDrag(model.begin(label(Edit.MOVE, items)), items, pane.axes(), pane.view(), box, reference(items, box), others(items),
                pane.snaps(), pressX, pressY);
    }

    private Drag begin(Handle handle) {
        Set<ScenePath> items = pane.movable();
        Box box = pane.handleBox();
        return handle == Handle.TURN
                ? new TurnDrag(model.begin(label(Edit.ROTATE, items)), items, pane.axes(), pane.view(), pivot(items, box), pane.snaps(),
                        pane.theme().palette().selected(), pressX, pressY)
                : new ResizeDrag(model.begin(label(Edit.RESIZE, items)), items, pane.axes(), pane.view(), box, inDepth(items), only(items).flatMap(at -> Pivots.given(model.scene(), at)), handle, pane.snaps(),
                        pane.isProportional(), pressX, pressY);
    }

    /** What items are turned about: one body about its pivot, others about the middle of their box. */
    private Vec3 pivot(Set<ScenePath> items, Box box) {
        return only(items).map(at -> Pivots.of(model.scene(), at)).orElseGet(() -> pane.axes().vector(box.centreU(), box.centreV()));
    }

    private static Optional<BodyAt> only(Set<ScenePath> items) {
        return items.size() == 1 ? Places.bodies(items).stream().findFirst() : Optional.empty();
    }

    /** What stays at its depth when items grow towards the viewer, too: where a single thing says it is, else their mean. */
    private Vec3 inDepth(Set<ScenePath> items) {
        List<Vec3> places = items.stream().map(this::place).toList();
        Vec3 sum = places.stream().reduce(Vec3.ZERO, Vec3::plus);
        return pane.axes().inDepth(places.size() == 1 ? sum : sum.times(1.0 / places.size()));
    }

    private Vec3 place(ScenePath item) {
        Scene scene = model.scene();
        if (item instanceof ScenePath.LightAt light) {
            return LightMoves.place(scene.lights().get(light.index()));
        }
        return item instanceof ScenePath.BodyAt body ? body.toWorld(scene).point(Vec3.ZERO)
                : item instanceof ScenePath.CameraAt camera ? scene.cameras().get(camera.index()).position() : Vec3.ZERO;
    }

    private Label label(Edit edit, Set<ScenePath> items) {
        return Label.of(edit, PathNames.of(model.scene(), items, pane.texts()));
    }

    /** What is put on the grid: where a single object says it is, else the corner of the box. */
    private Box reference(Set<ScenePath> items, Box box) {
        if (items.size() == 1 && items.iterator().next() instanceof ScenePath.BodyAt body) {
            Vec3 origin = body.toWorld(model.scene()).point(Vec3.ZERO);
            return Box.EMPTY.with(pane.axes().u(origin), pane.axes().v(origin));
        }
        return box.isEmpty() ? Box.EMPTY.with(0, 0) : box;
    }

    private Snapping others(Set<ScenePath> moving) {
        Figures figures = pane.figures();
        Set<Integer> objects = new HashSet<>();
        Places.bodies(moving).forEach(body -> objects.add(body.object().index()));
        List<Box> boxes = new ArrayList<>();
        for (int i = 0; i < figures.count(); i++) {
            Box box = figures.of(i).box();
            if (!box.isEmpty() && pane.view().shows(box) && !objects.contains(i) && !model.state().isHidden(ScenePath.body(i))) {
                boxes.add(box);
            }
        }
        return new Snapping(boxes);
    }

    private Optional<Grip> gripAt(double x, double y) {
        return pane.grips().stream().filter(grip -> pane.toPane(grip.place()).distance(x, y) <= GRIP).findFirst();
    }

    /** The line in which the plane that solids are cut by is seen there. */
    private Optional<SectionSkin.Line> lineAt(double x, double y) {
        return pane.section().flatMap(skin -> skin.line(pane.axes().along())).filter(line -> Drag.Cutting.distance(line, pane.axes(), pane.view(), x, y) <= LINE);
    }

    private Cursor cursor(double x, double y) {
        return gripAt(x, y).isPresent() ? Cursor.CROSSHAIR
                : lineAt(x, y).map(line -> line.axis().of(pane.axes().vector(1, 0)) != 0 ? Cursor.H_RESIZE : Cursor.V_RESIZE).orElse(Cursor.DEFAULT);
    }

    private void moved(MouseEvent event) {
        lastX = event.getX();
        lastY = event.getY();
        point();
        Optional<Handle> handle = pane.handleAt(lastX, lastY);
        pane.setHoverCursor(pane.edits().pipette().isActive() ? Cursor.CROSSHAIR : spaceHeld ? Cursor.OPEN_HAND : handle.map(Handle::cursor).orElseGet(() -> cursor(lastX, lastY)));
    }

    private void point() {
        pane.setPointed(Optional.of(pane.axes().vector(pane.view().u(lastX), pane.view().v(lastY))));
    }

    private void scrolled(ScrollEvent event) {
        event.consume();
        if (event.isInertia() || (event.getDeltaY() == 0 && event.getDeltaX() == 0)) {
            return;
        }
        if (event.isShiftDown()) {
            pane.show(pane.view().panned(event.getDeltaX() + event.getDeltaY(), 0));
        } else if (drag == null) {
            double notches = event.getMultiplierY() == 0 ? Math.signum(event.getDeltaY()) : event.getDeltaY() / 40;
            pane.show(pane.view().zoomed(Math.pow(ZOOM_PER_NOTCH, notches), event.getX(), event.getY()));
        }
    }

    private void keyPressed(KeyEvent event) {
        if (event.getCode() == KeyCode.SPACE) {
            spaceHeld = true;
            event.consume();
        } else if (event.getCode() == KeyCode.ESCAPE && (drag != null || pressed)) {
            next.drop();
            if (drag != null) {
                drag.cancel();
            }
            setDrag(null);
            pressed = false;
            event.consume();
        } else if (event.getCode() == KeyCode.D && !event.isShortcutDown() && drag != null && drag.copyOrNot()) {
            follow();
            event.consume();
        } else {
            keysChanged(event, event.getCode() == KeyCode.SHIFT || event.isShiftDown());
        }
    }

    private void keyReleased(KeyEvent event) {
        if (event.getCode() == KeyCode.SPACE) {
            spaceHeld = false;
        } else {
            keysChanged(event, event.isShiftDown() && event.getCode() != KeyCode.SHIFT);
        }
    }

    /** A key held or let go in mid-drag counts at once, not with the next movement only. */
    private void keysChanged(KeyEvent event, boolean straight) {
        if (drag != null) {
            keys = new Drag.Keys(event.isShortcutDown(), straight);
            follow();
        }
    }

    private void follow() {
        next.drop();
        point();
        Drag current = drag;
        if (current == null) {
            return;
        }
        if (!pane.edits().attempt(() -> current.to(lastX, lastY, keys))) {
            // A place that no scene can have, such as the camera on its own target: the last possible one stays shown.
            pane.setHoverCursor(Cursor.DISAPPEAR);
        }
        pane.setDrag(current, lastX, lastY);
    }

    private void setDrag(@Nullable Drag value) {
        drag = value;
        pane.setDrag(value, lastX, lastY);
    }
}
