package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.Rounds;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.command.MaterialDrop;
import cz.paprsek.fx.view.look.OwnLayout;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.motion.OnionSkin;
import cz.paprsek.fx.view.projection.Grips.Grip;
import cz.paprsek.fx.view.rays.DrawnRays;
import cz.paprsek.fx.view.section.SectionSkin;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import javafx.beans.InvalidationListener;
import javafx.beans.WeakInvalidationListener;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Point2D;
import javafx.scene.Cursor;
import javafx.scene.control.ContextMenu;
import javafx.scene.layout.Region;
import javafx.scene.shape.Rectangle;
import org.jspecify.annotations.Nullable;

/** The scene seen along an axis, without perspective, as {@link PaneLayers} draw it. */
public final class ProjectionPane extends Region {
    private final Edits edits;
    private final EditorModel model;
    private final Texts texts;
    private final Axes axes;
    private final ObservableValue<Theme> theme;
    private final BooleanProperty snapping;
    private final BooleanProperty proportional;
    private final Figures figures;
    private final Picker picker;
    private final PaneLayers layers;
    private final ReadOnlyObjectWrapper<Optional<Vec3>> pointed = new ReadOnlyObjectWrapper<>(Optional.empty());
    /** Held here, because what outlives the pane holds it weakly. */
    private final InvalidationListener onChange = changed -> redraw();
    private Viewport view = new Viewport(0, 0, 40, 0, 0);
    /** Whether the whole scene is shown, also when the pane's size changes: until the user looks at something closer. */
    private boolean fits = true;
    private int openings;
    private Optional<ContextMenu> menu = Optional.empty();

    /**
     * @param snapping whether drags keep to the grid and to other objects
     * @param proportional whether corner handles keep the proportions
     */
    public ProjectionPane(Edits edits, Axes axes, ObservableValue<Theme> theme, BooleanProperty snapping, BooleanProperty proportional) {
        this.edits = edits;
        this.model = edits.model();
        this.texts = edits.texts();
        this.axes = axes;
        this.theme = theme;
        this.snapping = snapping;
        this.proportional = proportional;
        this.figures = new Figures(axes);
        this.picker = new Picker(axes, figures);
        this.layers = new PaneLayers(this, figures);
        figures.show(model.scene(), model.gesturingProperty().get());
        setFocusTraversable(true);
        setMinSize(0, 0);
        getStyleClass().add("projection");
        getChildren().addAll(layers.all());
        Rectangle clip = new Rectangle();
        clip.widthProperty().bind(widthProperty());
        clip.heightProperty().bind(heightProperty());
        setClip(clip);
        WeakInvalidationListener weak = new WeakInvalidationListener(onChange);
        model.stateProperty().addListener(weak);
        model.gesturingProperty().addListener(weak);
        theme.addListener(weak);
        new PaneMouse(this);
        new PaneKeys(this);
    }

    /** Where in the world the mouse points: in the plane of the projection, 0 along the third axis. Empty if it is elsewhere. */
    public ReadOnlyObjectProperty<Optional<Vec3>> pointedProperty() {
        return pointed.getReadOnlyProperty();
    }

    public Axes axes() {
        return axes;
    }

    /** What is in the middle of the pane, at the depth of another point. */
    public Sight sight(Vec3 depth) {
        return Sight.at(axes.vector(view.centreU(), view.centreV()).plus(axes.inDepth(depth)), getHeight() / view.scale());
    }

    /** Where something is that is put at a point of this view, at the depth of what is looked at, and as large as there; if drags keep to a grid, on the finer of that and one for its size. */
    public Sight sightAt(double x, double y, Sight gaze) {
        return gaze.moved(axes.vector(view.u(x), view.v(y)).plus(axes.inDepth(gaze.point())), snaps(), Rounds.step(view.scale()));
    }

    /** The two coordinates of a point that this projection shows, to a pixel: "x 1.25   z −3". */
    public String describe(Vec3 point, Locale locale) {
        return axes.right().letter() + " " + view.text(axes.right().of(point), locale) + "   "
                + axes.up().letter() + " " + view.text(axes.up().of(point), locale);
    }

    /** Shows everything that has an end. */
    public void fitAll() {
        figures.show(model.scene(), model.gesturingProperty().get());
        show(view.fitting(figures.boxOfAll(model.state())));
        fits = true;
    }

    /** Shows what is selected as large as possible, or everything if nothing is. */
    public void fitSelection() {
        if (model.selection().isEmpty()) {
            fitAll();
        } else {
            figures.show(model.scene(), model.gesturingProperty().get());
            show(view.fitting(figures.box(model.selection())));
        }
    }

    /** Zooms about the middle. */
    public void zoom(double factor) {
        show(view.zoomed(factor, getWidth() / 2, getHeight() / 2));
    }

    /** Shows a point of the world on the pane: its coordinates there, pixels. */
    public Point2D toPane(Vec3 point) {
        return new Point2D(view.x(axes.u(point)), view.y(axes.v(point)));
    }

    /** Draws the rays of an explained pixel above everything. */
    public void setRays(Optional<DrawnRays> drawn) {
        layers.rays = drawn;
        redraw();
    }

    /**
     * Draws the ways of what is animated, and where it is at the time that is looked at.
     *
     * @param skin of this clock and the same model; other projections may draw it too
     */
    public void follow(Clock clock, OnionSkin skin) {
        layers.onion = Optional.of(skin);
        clock.secondsProperty().addListener(new WeakInvalidationListener(onChange));
        clock.openProperty().addListener(new WeakInvalidationListener(onChange));
        redraw();
    }

    /** Draws the plane that solids are cut by, and what they look like there. */
    public void cutBy(SectionSkin skin) {
        layers.section = Optional.of(skin);
        skin.follow(onChange);
    }

    /** The plane that solids are cut by, if there may be one. */
    Optional<SectionSkin> section() {
        return layers.section;
    }

    /** Which tell what is refused. */
    Edits edits() {
        return edits;
    }

    EditorModel model() {
        return model;
    }

    Texts texts() {
        return texts;
    }

    Theme theme() {
        return theme.getValue();
    }

    Viewport view() {
        return view;
    }

    Figures figures() {
        figures.show(model.scene(), model.gesturingProperty().get());
        return figures;
    }

    Picker picker() {
        figures.show(model.scene(), model.gesturingProperty().get());
        return picker;
    }

    boolean snaps() {
        return snapping.get();
    }

    /** Lets materials be dropped on bodies. */
    public void acceptMaterials() {
        MaterialDrop.accept(this, edits, event -> picker().at(model.state(), view, event.getX(), event.getY()).stream()
                .filter(BodyAt.class::isInstance).map(BodyAt.class::cast).findFirst(), body -> {
            layers.highlighted = body;
            redraw();
        });
    }

    boolean isProportional() {
        return proportional.get();
    }

    /** Shows a menu where the right button is clicked, or at the corner for a key. */
    public void setContextMenu(ContextMenu shown) {
        menu = Optional.of(shown);
        setOnContextMenuRequested(event -> {
            if (event.isKeyboardTrigger()) {
                Point2D corner = localToScreen(0, 0);
                shown.show(this, corner.getX(), corner.getY());
            }
            event.consume();
        });
    }

    Optional<ContextMenu> menu() {
        return menu;
    }

    void show(Viewport fresh) {
        view = fresh;
        fits = false;
        redraw();
    }

    /** @param x where the mouse is, pixels */
    void setDrag(@Nullable Drag value, double x, double y) {
        layers.drag = value;
        layers.mouse = new Point2D(x, y);
        redraw();
    }

    void setPointed(Optional<Vec3> value) {
        pointed.set(value);
    }

    /** Before the next frame. Its size is that of its place, so that nothing around is laid out for what is drawn. */
    private void redraw() {
        if (OwnLayout.suffices(this)) {
            setNeedsLayout(true);
        } else {
            requestLayout();
        }
    }

    /** What can be moved of what is selected. */
    Set<ScenePath> movable() {
        EditorState state = model.state();
        return state.locked().isEmpty() ? state.selection() : state.selection().stream().filter(item -> !state.isLocked(item)).collect(Collectors.toSet());
    }

    /** What is grabbed to change the selected cameras, and a light that is the only thing selected. */
    List<Grip> grips() {
        Set<ScenePath> items = movable();
        Grips grips = new Grips(model.scene(), axes, view, model.copies());
        return items.stream().filter(item -> item instanceof CameraAt || items.size() == 1).filter(item -> !model.state().isHidden(item))
                .flatMap(item -> grips.of(item).stream()).toList();
    }

    /** The box of the handles; empty if there is nothing to resize. */
    Box handleBox() {
        return layers.handleBox();
    }

    /** What the handles of an empty or invisible box cannot do. */
    Optional<Handle> handleAt(double x, double y) {
        return Handle.at(view, handleBox(), x, y);
    }

    void setHoverCursor(Cursor cursor) {
        if (!Objects.equals(getCursor(), cursor)) {
            setCursor(cursor);
        }
    }

    @Override
    protected void layoutChildren() {
        double width = getWidth();
        double height = getHeight();
        if (width <= 0 || height <= 0) {
            return;
        }
        layers.setSize(width, height);
        boolean otherSize = view.width() != width || view.height() != height;
        view = view.withSize(width, height);
        figures.show(model.scene(), model.gesturingProperty().get());
        boolean opened = model.openingsProperty().get() != openings;
        openings = model.openingsProperty().get();
        fits |= opened;
        if (fits && (otherSize || opened)) {
            view = view.fitting(figures.boxOfAll(model.state()));
        }
        layers.draw();
    }

}
