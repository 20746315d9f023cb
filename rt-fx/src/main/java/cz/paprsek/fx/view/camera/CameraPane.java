package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.CutPlane;
import cz.paprsek.fx.model.edit.Visible;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.command.MaterialDrop;
import cz.paprsek.fx.view.picture.Framing;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.picture.PictureStyle;
import cz.paprsek.fx.view.rays.BodyOutline.Look;
import cz.paprsek.fx.view.rays.DrawnRays;
import cz.paprsek.render.Tile;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import javafx.beans.InvalidationListener;
import javafx.beans.WeakInvalidationListener;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.ObservableValue;
import javafx.beans.value.WeakChangeListener;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.geometry.Pos;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Label;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;

/**
 * The live picture of the model's scene, as its camera sees it, without what is hidden. Mouse and keys move the camera, see {@link CameraHand}; a click selects the
 * object that is seen at the pixel, a second one the operand of it, Alt and a click the innermost operand at once.
 */
public final class CameraPane extends StackPane implements AutoCloseable {
    /** More than so many things are not outlined while a hand moves them. */
    private static final int MANY = 200;

    private final EditorModel model;
    private final LivePicture picture;
    private final CameraHand hand;
    private final PictureSelection selection;
    private final ReadOnlyObjectWrapper<Optional<PicturePoint>> pointed = new ReadOnlyObjectWrapper<>(Optional.empty());
    /** Held here, because the model, which may outlive the pane, holds it weakly. */
    private final ChangeListener<EditorState> onState;
    private final Viewpoint view;
    private final InvalidationListener onTime = time -> show();
    private Optional<Clock> clock = Optional.empty();
    private Visible visible;
    /** Whether something has changed while it was in no window. */
    private boolean isStale;
    private Optional<ObjectHand> objects = Optional.empty();
    private Optional<BodyAt> hovered = Optional.empty();
    private Optional<BodyAt> droppedOn = Optional.empty();
    private final Blink blinking = new Blink(this::show);
    private Optional<RegionHand> regions = Optional.empty();
    private ObjectProperty<Optional<CutPlane>> cut = new SimpleObjectProperty<>(Optional.empty());
    private final InvalidationListener onCut = changed -> show();
    private Runnable onSelection = () -> {};
    private Predicate<PicturePoint> clickedFirst = point -> false;
    private final AwaitedClick awaited;
    private Optional<ContextMenu> menu = Optional.empty();

    /** @param onFault is told, on JavaFX's thread, if the renderer fails */
    public CameraPane(EditorModel model, Consumer<Throwable> onFault) {
        this(model, new SceneCamera(model), onFault);
    }

    /** A view of its own beside that of the scene's camera, which it leaves alone; it begins where that is. */
    public static CameraPane free(EditorModel model, Consumer<Throwable> onFault) {
        CameraPane pane = new CameraPane(model, new FreeCamera(model.state().camera()), onFault);
        pane.setId("free-pane");
        return pane;
    }

    private CameraPane(EditorModel model, Viewpoint view, Consumer<Throwable> onFault) {
        this.model = model;
        this.view = view;
        this.visible = Visible.of(view.seen(model.state()));
        this.picture = new LivePicture(visible.scene(), model.assets(), onFault);
        this.hand = new CameraHand(picture, view);
        this.selection = new PictureSelection(model);
        this.awaited = new AwaitedClick(picture);
        Label size = new Label();
        size.getStyleClass().add("picture-size");
        size.setMouseTransparent(true);
        size.setMinWidth(Region.USE_PREF_SIZE);
        StackPane.setAlignment(size, Pos.BOTTOM_LEFT);
        setId("camera-pane");
        getStyleClass().add("camera-pane");
        getStylesheets().add(PictureStyle.sheet());
        getChildren().addAll(picture, size);
        picture.setOnMouseReleased(this::released);
        addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE && giveUp()) {
                event.consume();
            }
        });
        picture.setOnMouseMoved(event -> point(picture.at(event.getX(), event.getY())));
        picture.setOnMouseExited(event -> point(Optional.empty()));
        picture.overlay().setPainter(this::draw);
        Runnable caption = () -> size.setText(model.scene().settings().width() + " × " + model.scene().settings().height()
                + (picture.completeProperty().get() ? "" : " …"));
        picture.completeProperty().addListener((property, old, now) -> caption.run());
        onState = (property, old, now) -> {
            if (!old.selection().equals(now.selection())) {
                blinking.end();
            }
            if (old.eye() != now.eye() || !old.scene().equals(now.scene()) || !old.hidden().equals(now.hidden())) {
                show();
                caption.run();
            } else if (!old.selection().equals(now.selection())) {
                picture.overlay().repaint();
                onSelection.run();
            }
        };
        view.setOnMoved(this::show);
        sceneProperty().addListener((property, old, now) -> {
            if (isStale) {
                show();
            }
        });
        model.stateProperty().addListener(new WeakChangeListener<>(onState));
        caption.run();
    }

    /** Where in the picture the mouse is; empty beside it. */
    public ReadOnlyObjectProperty<Optional<PicturePoint>> pointedProperty() {
        return pointed.getReadOnlyProperty();
    }

    /** Lets somebody else have a click first: if it returns true, nothing is selected. */
    public void setClickedFirst(Predicate<PicturePoint> listener) {
        clickedFirst = listener;
    }

    /**
     * Waits for a click into the picture, which goes to a listener and selects nothing; Escape, a click beside, or whoever waits for something next, ends that.
     *
     * @param onGivenUp is run if it ends without a click
     */
    public void awaitClick(Consumer<PicturePoint> listener, Runnable onGivenUp) {
        freeMouse();
        awaited.start(listener, onGivenUp);
    }

    /** Gives up what the mouse was asked for, as Escape does: a click, the part that is rendered alone, or a rubber band; whether there was anything. */
    public boolean giveUp() {
        return awaited.end(Optional.empty()) || regions.filter(RegionHand::giveUp).isPresent() || objects.filter(ObjectHand::giveUpBand).isPresent();
    }

    /** Gives up whatever the mouse was asked for; the part that is rendered alone stays as it is. */
    public void freeMouse() {
        awaited.end(Optional.empty());
        regions.ifPresent(RegionHand::disarm);
        objects.ifPresent(ObjectHand::giveUpBand);
    }

    /** Lets materials be dropped on the objects of the picture. */
    public void acceptMaterials(Edits edits) {
        MaterialDrop.accept(picture, edits, event -> picture.at(event.getX(), event.getY()).flatMap(this::body).map(BodyAt::object),
                body -> {
                    droppedOn = body;
                    picture.overlay().repaint();
                });
    }

    /**
     * Lets what is selected be moved, turned and scaled in the picture.
     *
     * @param snapping whether drags keep to round numbers and to other objects
     */
    public void acceptEdits(Edits edits, BooleanProperty snapping) {
        ObjectHand fresh = new ObjectHand(picture, edits, view, snapping::get, this::now, this::look);
        objects = Optional.of(fresh);
        fresh.setOnBand(this::freeMouse);
        ModeBox box = new ModeBox(edits.texts(), fresh.modeProperty());
        StackPane.setAlignment(box, Pos.TOP_RIGHT);
        box.setVisible(fresh.hasHandles());
        onSelection = () -> box.setVisible(fresh.hasHandles());
        getChildren().add(box);
    }

    /** Shows solids cut open, as long as a plane is given. */
    public void cutBy(ObjectProperty<Optional<CutPlane>> plane) {
        cut = plane;
        CutBox box = new CutBox(plane);
        StackPane.setAlignment(box, Pos.BOTTOM_RIGHT);
        getChildren().add(box);
        plane.addListener(onCut);
    }

    /**
     * Lets the part be drawn that is rendered alone, and shows it.
     *
     * @param onRegion is told of another part, or of none
     */
    public void acceptRegions(ObservableValue<Framing> framing, Consumer<Optional<Tile>> onRegion) {
        regions = Optional.of(new RegionHand(this, picture, framing, onRegion));
    }

    /** Has the next drag draw the part that is rendered alone. */
    public void drawRegion() {
        freeMouse();
        regions.ifPresent(RegionHand::arm);
    }

    /** Shows the scene without some of it and with it, a few times: what is it good for? Selecting something else ends that. */
    public void blink(Set<ScenePath> items) {
        blinking.start(items);
    }

    /** Whether something is blinking. */
    public boolean isBlinking() {
        return blinking.isRunning();
    }

    /** From where it is seen. */
    public Camera camera() {
        return view.camera();
    }

    /** Looks from elsewhere; of the scene's camera, one step of the history. */
    public void look(UnaryOperator<Camera> change) {
        if (view.isLocked()) {
            hand.tellLocked();
        } else {
            view.change(change);
        }
    }

    /** Shows the scene at the time that is looked at. */
    public void follow(Clock followed) {
        clock = Optional.of(followed);
        followed.secondsProperty().addListener(new WeakInvalidationListener(onTime));
        show();
    }

    private EditorState now() {
        return clock.map(Clock::shown).orElseGet(model::state);
    }

    private void show() {
        isStale = getScene() == null;
        if (isStale) {
            return;
        }
        Visible whole = Visible.of(view.seen(now().withHidden(model.state().hidden())), blinking.without());
        visible = cut.getValue().map(plane -> plane.of(whole)).orElse(whole);
        picture.show(visible.scene(), model.assets());
        picture.overlay().repaint();
        onSelection.run();
    }

    private void point(Optional<PicturePoint> at) {
        pointed.set(at);
        Optional<BodyAt> under = at.filter(point -> objects.isPresent()).flatMap(this::body).map(selection::deeper)
                .filter(body -> !model.state().isLocked(body) && objects.filter(ObjectHand::isOnHandle).isEmpty());
        if (!under.equals(hovered)) {
            hovered = under;
            picture.overlay().repaint();
        }
    }

    private Optional<Bounds> draw(GraphicsContext g) {
        Extent extent = new Extent(g.getCanvas());
        Outlines outlines = new Outlines(g, now(), view.camera(now()), extent);
        hovered.filter(body -> body.isIn(model.scene()) && !model.selection().contains(body)).ifPresent(body -> outlines.draw(body, Look.FAINT));
        if (objects.isPresent() && (model.selection().size() <= MANY || !model.gesturingProperty().get())) {
            outlines.selected();
        }
        droppedOn.filter(body -> body.isIn(model.scene())).ifPresent(body -> outlines.draw(body, Look.STRONG));
        return objects.filter(known -> known.draw(g, extent)).isPresent() ? Optional.empty() : Optional.of(extent.bounds());
    }

    public Optional<BodyAt> body(PicturePoint point) {
        return point.place().map(visible::original).filter(BodyAt.class::isInstance).map(BodyAt.class::cast);
    }

    /** Shows a menu where the right button is clicked, or at the corner for a key. */
    public void setContextMenu(ContextMenu shown) {
        menu = Optional.of(shown);
        picture.setOnContextMenuRequested(event -> {
            if (event.isKeyboardTrigger()) {
                Point2D corner = picture.localToScreen(0, 0);
                shown.show(picture, corner.getX(), corner.getY());
            }
            event.consume();
        });
    }

    /** Is told when the camera should move, but is locked. */
    public void setOnLocked(Runnable listener) {
        hand.setOnLocked(listener);
    }

    /** Draws rays above the picture. */
    public void setRays(Optional<DrawnRays> rays) {
        picture.setRays(rays);
    }

    /** Is told when the picture of another scene, or of another size, has come to be seen. */
    public void setOnRefreshed(Runnable listener) {
        picture.setOnRefreshed(listener);
    }

    /** The point of the picture at shares of its width and height; empty as long as there is no picture. */
    public Optional<PicturePoint> at(double across, double down) {
        return picture.atShare(across, down);
    }

    /** The point of the picture at a point of this view; empty beside it. */
    public Optional<PicturePoint> pointAt(double x, double y) {
        return picture.at(x, y);
    }

    /** Whether the picture is that of the model's scene, with all its samples. */
    public boolean isComplete() {
        return picture.completeProperty().get();
    }

    /** The keyboard goes to the picture. */
    @Override
    public void requestFocus() {
        picture.requestFocus();
    }

    /** Ends rendering for ever. */
    @Override
    public void close() {
        blinking.stop();
        cut.removeListener(onCut);
        picture.close();
    }

    private void released(MouseEvent event) {
        event.consume();
        menu.ifPresent(ContextMenu::hide);
        if (objects.isPresent() && objects.get().release(event)) {
            hand.forget();
            return;
        }
        if (hand.release(event)) {
            return;
        }
        Optional<PicturePoint> point = picture.at(event.getX(), event.getY());
        if (event.getButton() == MouseButton.SECONDARY) {
            point.flatMap(this::body).ifPresent(selection::ask);
            menu.ifPresent(known -> known.show(picture, event.getScreenX(), event.getScreenY()));
            return;
        }
        if (event.getButton() != MouseButton.PRIMARY || awaited.end(point) || point.isEmpty() || clickedFirst.test(point.get())) {
            return;
        }
        selection.click(event, point.get().place().map(visible::original));
    }
}
