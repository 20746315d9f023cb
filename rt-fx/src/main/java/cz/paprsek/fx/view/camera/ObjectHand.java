package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.fx.model.edit.Alignment;
import cz.paprsek.fx.model.edit.Alignment.Line;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.fx.model.edit.LightMoves;
import cz.paprsek.fx.model.edit.Looks;
import cz.paprsek.fx.model.edit.Pivots;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.Point2D;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import org.jspecify.annotations.Nullable;

/**
 * Moves, turns and scales what is selected in a picture: by handles, or by keys: G, R or S, then x, y or z, a number and Enter. What is typed in the middle of a drag counts for
 * more than the mouse. Each is one step of the history; Escape cancels it.
 */
final class ObjectHand {
    private static final double SLACK = 3;

    private final LivePicture picture;
    private final EditorModel model;
    private final Edits edits;
    private final Viewpoint view;
    private final BooleanSupplier snapping;
    private final Supplier<EditorState> shown;
    private final Consumer<UnaryOperator<Camera>> look;
    private final BandHand band;
    private Runnable onBand = () -> {};
    private final ObjectProperty<Handles.Mode> mode = new SimpleObjectProperty<>(Handles.Mode.MOVE);
    private Optional<Optional<Axis>> hovered = Optional.empty();
    /** What is pressed, until it is let go. */
    private Optional<Optional<Axis>> held = Optional.empty();
    private @Nullable Handles pressedOn;
    private @Nullable Manipulation doing;
    private Point2D start = Point2D.ZERO;
    private Point2D mouse = Point2D.ZERO;
    private boolean isFree;
    /** Whether a drag has been ended by a key, so that it means nothing until it is let go. */
    private boolean isOver;
    /** Where the handles are, in these states. */
    private Optional<Vec3> middle = Optional.empty();
    private @Nullable EditorState middleOf;
    private @Nullable EditorState middleIn;

    /**
     * @param shown the state that is in the picture, which may be that of another time
     * @param look changes the camera, or tells that it is locked
     */
    ObjectHand(LivePicture picture, Edits edits, Viewpoint view, BooleanSupplier snapping, Supplier<EditorState> shown, Consumer<UnaryOperator<Camera>> look) {
        this.picture = picture;
        this.model = edits.model();
        this.edits = edits;
        this.view = view;
        this.snapping = snapping;
        this.shown = shown;
        this.look = look;
        this.band = new BandHand(picture, model, view, shown);
        picture.addEventFilter(MouseEvent.MOUSE_PRESSED, this::pressed);
        picture.addEventFilter(MouseEvent.MOUSE_DRAGGED, this::dragged);
        picture.addEventFilter(MouseEvent.MOUSE_MOVED, this::moved);
        picture.addEventFilter(KeyEvent.KEY_PRESSED, this::key);
        picture.addEventFilter(KeyEvent.KEY_TYPED, this::typed);
        picture.focusedProperty().addListener((property, old, now) -> {
            if (!now && held.isEmpty()) {
                end(true);
            }
        });
        mode.addListener((property, old, now) -> repaint());
    }

    ObjectProperty<Handles.Mode> modeProperty() {
        return mode;
    }

    /** Whether there is something to be moved. */
    boolean hasHandles() {
        return !movable().isEmpty();
    }

    private Set<ScenePath> movable() {
        Set<ScenePath> items = new LinkedHashSet<>(model.selection());
        items.removeIf(item -> model.state().isLocked(item) || model.state().isHidden(item) || (item instanceof CameraAt camera && camera.index() == model.state().eye()));
        return items;
    }

    /** What they are turned about: one thing about its pivot, several about the middle of these. */
    private static Optional<Vec3> middle(Set<ScenePath> items, Scene scene) {
        List<Vec3> places = items.stream().map(item -> place(item, scene)).toList();
        return places.isEmpty() ? Optional.empty() : Optional.of(places.stream().reduce(Vec3.ZERO, Vec3::plus).times(1.0 / places.size()));
    }

    private static Vec3 place(ScenePath item, Scene scene) {
        return item instanceof BodyAt at ? Pivots.of(scene, at) : item instanceof LightAt light ? LightMoves.place(scene.lights().get(light.index()))
                : item instanceof CameraAt camera ? scene.cameras().get(camera.index()).position() : Vec3.ZERO;
    }

    /** Where handles are seen: none of what is elsewhere at the time that is looked at, for that is not what would be moved. */
    @SuppressWarnings("ReferenceEquality")
    private Optional<Vec3> middle() {
        EditorState state = model.state();
        EditorState now = shown.get();
        if (middleOf != state || middleIn != now) {
            Set<ScenePath> items = movable();
            Optional<Vec3> written = middle(items, state.scene());
            boolean isWritten = now == state || (items.stream().allMatch(item -> item.isIn(now.scene())) && middle(items, now.scene()).equals(written));
            middle = written.filter(at -> isWritten);
            middleOf = state;
            middleIn = now;
        }
        return middle;
    }

    private Optional<Handles> handles() {
        return middle().flatMap(at -> handles(at, view.camera(shown.get())));
    }

    private Optional<Handles> handles(Vec3 at, Camera camera) {
        double width = picture.overlay().getWidth();
        double height = picture.overlay().getHeight();
        return width >= 1 && height >= 1 ? Handles.of(mode.get(), camera, width, height, at) : Optional.empty();
    }

    private void moved(MouseEvent event) {
        mouse = picture.inFrame(event.getX(), event.getY());
        Optional<Optional<Axis>> now = handles().flatMap(known -> known.at(mouse.getX(), mouse.getY()));
        if (!now.equals(hovered)) {
            hovered = now;
            repaint();
        }
    }

    /** Whether the mouse is on a handle, so that nothing else is meant. */
    boolean isOnHandle() {
        return hovered.isPresent();
    }

    private void pressed(MouseEvent event) {
        // Another button in the middle of a drag ends it.
        isOver = held.isPresent() && (isOver || doing != null);
        end(true);
        Point2D at = picture.inFrame(event.getX(), event.getY());
        if (band.pressed(event, at)) {
            picture.requestFocus();
            event.consume();
            return;
        }
        boolean isPlain = event.getButton() == MouseButton.PRIMARY && !event.isShiftDown() && !event.isAltDown() && !edits.pipette().isActive();
        handles().filter(known -> isPlain).ifPresent(known -> {
            held = known.at(at.getX(), at.getY());
            pressedOn = known;
            start = at;
            mouse = at;
            isFree = event.isShortcutDown();
            isOver = false;
        });
    }

    private void dragged(MouseEvent event) {
        mouse = picture.inFrame(event.getX(), event.getY());
        if (band.dragged(mouse)) {
            event.consume();
            return;
        }
        if (isOver) {
            event.consume();
            return;
        }
        Handles handles = pressedOn;
        if (held.isEmpty() || handles == null) {
            return;
        }
        event.consume();
        isFree = event.isShortcutDown();
        if (doing == null && mouse.distance(start) > SLACK) {
            doing = begin(handles, held.get());
        }
        follow();
    }

    /** Ends a drag; whether it was one, rather than a click. */
    boolean release(MouseEvent event) {
        dragged(event);
        boolean wasBand = band.release();
        boolean wasDrag = isOver || (held.isPresent() && doing != null);
        isOver = false;
        held = Optional.empty();
        pressedOn = null;
        end(true);
        return wasBand || wasDrag;
    }

    private Manipulation begin(Handles handles, Optional<Axis> axis) {
        Edit edit = handles.mode() == Handles.Mode.MOVE ? Edit.MOVE : handles.mode() == Handles.Mode.TURN ? Edit.ROTATE : Edit.RESIZE;
        Set<ScenePath> items = movable();
        return new Manipulation(model.begin(Label.of(edit, PathNames.of(model.scene(), items, edits.texts()))), items, handles, axis);
    }

    private void follow() {
        Manipulation now = doing;
        if (now != null && held.isPresent()) {
            edits.attempt(() -> now.to(start.getX(), start.getY(), mouse.getX(), mouse.getY(), snapping.getAsBoolean() && !isFree));
            repaint();
        }
    }

    /** Begins to move, turn or scale by keys. */
    void begin(Handles.Mode wanted) {
        end(true);
        mode.set(wanted);
        picture.requestFocus();
        // What is typed counts from where things are written to be, whatever time is looked at.
        doing = middle(movable(), model.scene()).flatMap(at -> handles(at, view.camera())).map(known -> begin(known, Optional.empty())).orElse(null);
        repaint();
    }

    private void end(boolean keep) {
        Manipulation ended = doing;
        doing = null;
        if (ended != null) {
            if (keep) {
                ended.gesture().commit();
            } else {
                ended.gesture().cancel();
            }
            repaint();
        }
    }

    private void key(KeyEvent event) {
        if (event.isShortcutDown() || event.isAltDown() || event.isMetaDown()) {
            return;
        }
        Manipulation now = doing;
        boolean known = (now == null || !now.gesture().isOpen()) ? idle(event.getCode()) : busy(now, event.getCode());
        if (known) {
            event.consume();
            repaint();
        }
    }

    /** Is told before the mouse is for a rubber band. */
    void setOnBand(Runnable listener) {
        onBand = listener;
    }

    /** Gives up a rubber band that was asked for or is drawn; whether there was one. */
    boolean giveUpBand() {
        Manipulation now = doing;
        boolean was = band.isAwaited() && (now == null || !now.gesture().isOpen()) && idle(KeyCode.ESCAPE);
        if (was) {
            repaint();
        }
        return was;
    }

    private boolean idle(KeyCode code) {
        isOver = isOver || (doing != null && held.isPresent());
        doing = null;
        switch (code) {
            case G -> begin(Handles.Mode.MOVE);
            case R -> begin(Handles.Mode.TURN);
            case S -> begin(Handles.Mode.SCALE);
            case B -> {
                onBand.run();
                band.arm();
            }
            case F -> look.accept(camera -> Looks.at(Alignment.around(shown.get(), shown.get().selection()), camera));
            case ESCAPE -> {
                isOver = isOver || band.isDrawn();
                return band.disarm();
            }
            default -> {
                return false;
            }
        }
        return true;
    }

    private boolean busy(Manipulation now, KeyCode code) {
        switch (code) {
            case X -> type(now, now.typed().along(Axis.X));
            case Y -> type(now, now.typed().along(Axis.Y));
            case Z -> type(now, now.typed().along(Axis.Z));
            case BACK_SPACE -> type(now, now.typed().shorter());
            case D -> edits.attempt(now::copyOrNot);
            case ENTER, ESCAPE -> {
                isOver = held.isPresent();
                end(code == KeyCode.ENTER);
            }
            case G, R, S -> {
                if (held.isEmpty()) {
                    end(false);
                    return idle(code);
                }
            }
            case TAB -> {
                return false;
            }
            default -> {
                return true;
            }
        }
        return true;
    }

    private void type(Manipulation now, TypedAmount amount) {
        edits.attempt(() -> now.type(amount));
    }

    private void typed(KeyEvent event) {
        Manipulation now = doing;
        if (now != null && !event.isShortcutDown() && event.getCharacter().length() == 1) {
            type(now, now.typed().with(event.getCharacter().charAt(0)));
            event.consume();
            repaint();
        }
    }

    private void repaint() {
        picture.overlay().repaint();
    }

    /**
     * Handles, lines that something has come to, and figures.
     *
     * @return whether that may be anywhere, rather than within the extent
     */
    boolean draw(GraphicsContext g, Extent extent) {
        band.draw(g);
        handles().ifPresent(known -> {
            known.measure(extent);
            known.draw(g, held.isPresent() ? held : hovered);
        });
        Manipulation now = doing;
        if (now != null && now.gesture().isOpen()) {
            Outlines outlines = new Outlines(g, model.state(), view.camera(shown.get()), extent);
            now.guides().forEach(line -> guide(outlines, line, now.middle()));
            String figures = now.figures(edits.texts().locale());
            Plates.above(g, now.typed().isNone() && held.isEmpty() ? edits.texts().of("handles.prompt") : figures);
            return true;
        }
        return band.isDrawn();
    }

    private static void guide(Outlines outlines, Line line, Vec3 middle) {
        Vec3 other = line.other().middle();
        Axis axis = line.axis();
        Vec3 onOther = other.plus(axis.times(line.place() - axis.of(other)));
        Vec3 onOwn = middle.plus(axis.times(line.place() - axis.of(middle)));
        outlines.guide(onOther, onOwn);
    }
}
