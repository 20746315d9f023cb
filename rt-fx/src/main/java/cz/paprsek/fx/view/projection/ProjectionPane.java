package cz.paprsek.fx.view.projection;

import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.edit.Rounds;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.command.MaterialDrop;
import cz.paprsek.fx.view.look.Layer;
import cz.paprsek.fx.view.look.OwnLayout;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.motion.OnionSkin;
import cz.paprsek.fx.view.projection.Grips.Grip;
import cz.paprsek.fx.view.rays.DrawnRays;
import cz.paprsek.fx.view.rays.RayPainter;
import cz.paprsek.fx.view.section.SectionSkin;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.beans.InvalidationListener;
import javafx.beans.WeakInvalidationListener;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Cursor;
import javafx.scene.control.ContextMenu;
import javafx.scene.layout.Region;
import javafx.scene.shape.Rectangle;
import org.jspecify.annotations.Nullable;

/**
 * The scene seen along an axis, without perspective. What is selected, the signs of cameras, and handles are drawn on layers of their own above that of the
 * rest, so that selecting and dragging among ten thousand objects need not draw them all anew.
 */
public final class ProjectionPane extends Region {
    /** About a selection's box, so that it holds all handles, pixels. */
    private static final double AIR = 36;
    /** By how much a line may be elsewhere while it is dragged, pixels. */
    private static final double MISSED = 0.01;

    /** All on which the lowest layer depends, besides the objects. What a gesture changes is drawn above, and apart from the rest. */
    private record Look(Viewport view, Theme theme, Set<ScenePath> apart, Set<ScenePath> hidden) {}

    /**
     * Many bodies that a hand holds, as they have been drawn, all in sight: where they are only moved, all of the layer is.
     *
     * @param others what is selected besides
     * @param box around the bodies
     */
    private record Held(Scene scene, Set<ScenePath> selection, List<BodyAt> bodies, List<ScenePath> others, Viewport view, Box box) {}

    private final Edits edits;
    private final EditorModel model;
    private final Texts texts;
    private final Axes axes;
    private final ObservableValue<Theme> theme;
    private final BooleanProperty snapping;
    private final BooleanProperty proportional;
    private final Layer rest = new Layer("rest");
    private final Layer selected = new Layer("selected");
    private final Layer signs = new Layer("signs");
    private final Layer grabbed = new Layer("grabbed");
    private final Figures figures;
    private final Picker picker;
    private final ReadOnlyObjectWrapper<Optional<Vec3>> pointed = new ReadOnlyObjectWrapper<>(Optional.empty());
    private Optional<DrawnRays> rays = Optional.empty();
    /** Held here, because what outlives the pane holds it weakly. */
    private final InvalidationListener onChange = changed -> redraw();
    private Viewport view = new Viewport(0, 0, 40, 0, 0);
    /** Whether the whole scene is shown, also when the pane's size changes: until the user looks at something closer. */
    private boolean fits = true;
    private int openings;
    private @Nullable Held held;
    /** The box of the handles, and of what state. */
    private Box handles = Box.EMPTY;
    private @Nullable EditorState handled;
    private @Nullable Look drawnLook;
    private Scene drawn = Scene.EMPTY;
    private @Nullable Drag drag;
    private Point2D mouse = Point2D.ZERO;
    private Optional<ContextMenu> menu = Optional.empty();
    private Optional<BodyAt> highlighted = Optional.empty();
    private Optional<OnionSkin> onion = Optional.empty();
    private Optional<SectionSkin> section = Optional.empty();

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
        figures.show(model.scene(), model.gesturingProperty().get());
        setFocusTraversable(true);
        setMinSize(0, 0);
        getStyleClass().add("projection");
        getChildren().addAll(rest, selected, signs, grabbed);
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
        rays = drawn;
        redraw();
    }

    /**
     * Draws the ways of what is animated, and where it is at the time that is looked at.
     *
     * @param skin of this clock and the same model; other projections may draw it too
     */
    public void follow(Clock clock, OnionSkin skin) {
        onion = Optional.of(skin);
        clock.secondsProperty().addListener(new WeakInvalidationListener(onChange));
        clock.openProperty().addListener(new WeakInvalidationListener(onChange));
        redraw();
    }

    /** Draws the plane that solids are cut by, and what they look like there. */
    public void cutBy(SectionSkin skin) {
        section = Optional.of(skin);
        skin.follow(onChange);
    }

    /** The plane that solids are cut by, if there may be one. */
    Optional<SectionSkin> section() {
        return section;
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
            highlighted = body;
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
        drag = value;
        mouse = new Point2D(x, y);
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
    @SuppressWarnings("ReferenceEquality")
    Box handleBox() {
        EditorState state = model.state();
        if (state != handled) {
            handled = state;
            handles = handleBox(figures());
        }
        return handles;
    }

    private Box handleBox(Figures shown) {
        Set<ScenePath> items = movable();
        boolean hasSize = items.stream().anyMatch(BodyAt.class::isInstance) || Places.lights(items).stream().filter(light -> light.isIn(model.scene()))
                .anyMatch(light -> !LightSketch.of(model.scene().lights().get(light.index()), axes).extent().isEmpty());
        return hasSize ? shown.box(items) : Box.EMPTY;
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
        List.of(rest, selected, signs, grabbed).forEach(layer -> layer.setSize(width, height));
        boolean otherSize = view.width() != width || view.height() != height;
        view = view.withSize(width, height);
        figures.show(model.scene(), model.gesturingProperty().get());
        boolean opened = model.openingsProperty().get() != openings;
        openings = model.openingsProperty().get();
        fits |= opened;
        if (fits && (otherSize || opened)) {
            view = view.fitting(figures.boxOfAll(model.state()));
        }
        EditorState state = model.state();
        Set<ScenePath> apart = model.gesturingProperty().get() ? state.selection() : Set.of();
        Look look = new Look(view, theme(), apart, state.hidden());
        if (!look.equals(drawnLook) || !figures.isLike(drawn, apart)) {
            rest.draw(new Object(), g -> {
                Grid.draw(g, view, axes, theme().palette());
                new Painter(g, view, axes, theme().palette()).rest(state.hidden(), apart, figures);
            });
            drawnLook = look;
            drawn = state.scene();
        }
        draw(state);
    }

    private void draw(EditorState state) {
        Painter painter = new Painter(selected.getGraphicsContext2D(), view, axes, theme().palette());
        boolean isAlone = section.filter(SectionSkin::isSeen).isEmpty() && onion.filter(OnionSkin::isSeen).isEmpty() && highlighted.isEmpty();
        boolean isInHand = isAlone && (drag != null || model.gesturingProperty().get());
        Held before = held;
        Optional<Vec3> moved = isInHand && before != null && view.equals(before.view) && state.selection().equals(before.selection)
                ? figures.movedSince(before.scene, before.bodies, MISSED / view.scale()) : Optional.empty();
        double byU = moved.map(axes::u).orElse(0.0);
        double byV = moved.map(axes::v).orElse(0.0);
        selected.setTranslateX(byU * view.scale());
        selected.setTranslateY(-byV * view.scale());
        Box box = before != null && moved.isPresent() ? before.box.moved(byU, byV).union(figures.box(before.others)) : figures.box(state.selection());
        if (moved.isPresent() && state.locked().isEmpty()) {
            handled = state;
            handles = box;
        }
        if (moved.isEmpty()) {
            held = isInHand ? held(state) : null;
            selected.draw(new Object(), g -> {
                section.ifPresent(skin -> skin.draw(g, theme().palette(), axes.along(), this::toPane));
                section.filter(skin -> skin.isHeld() && drag == null).flatMap(skin -> skin.line(axes.along())).ifPresent(line ->
                        Plate.beside(g, view, Drag.Cutting.figures(line, view, texts.locale()), toPane(Drag.Cutting.middle(line, axes, view)), theme().palette()));
                onion.ifPresent(skin -> {
                    skin.passing((object, isSelected) -> painter.moment(figures.passing(object), isSelected));
                    skin.ways(g, theme().palette(), this::toPane);
                });
                highlighted.filter(body -> body.isIn(state.scene())).ifPresent(body -> painter.highlighted(figures.of(body)));
                if (!state.selection().isEmpty()) {
                    painter.selected(state, figures);
                }
            });
        }
        Box grabs = handleBox();
        List<Grip> grips = grips();
        painter.avoid(state, grabs, grips);
        Painter above = painter.on(grabbed.getGraphicsContext2D());
        // Before the names of cameras, which may be many.
        Runnable name = !box.isEmpty() && view.shows(box) ? above.name(PathNames.of(state.scene(), state.selection(), texts), box) : () -> {};
        List<CameraSketch> cameras = IntStream.range(0, state.scene().cameras().size()).mapToObj(i -> CameraSketch.of(state.scene(), i)).toList();
        signs.draw(List.of(view, theme(), state.hidden(), state.eye(), cameras, Places.cameras(state.selection()), cameras.size() > 1 ? List.of(above.taken(), state.scene().cameras()) : 1), g -> {
            Grid.numbers(g, view, axes, theme().palette(), texts.locale());
            above.on(g).cameras(state, cameras, texts);
        });
        grabbed.draw(new Object(), g -> {
            if (!state.selection().isEmpty()) {
                above.selectedLights(state);
                above.handles(grabs, true);
                name.run();
                above.grips(grips);
            }
            rays.ifPresent(RayPainter.on(g, theme(), (from, to) -> List.of(segment(from, to)))::draw);
            if (drag != null) {
                drag.draw(g);
                Plate.beside(g, view, drag.figures(texts.locale()), mouse, theme().palette());
            }
        });
        List<Bounds> parts = new ArrayList<>(above.taken().subList(painter.taken().size(), above.taken().size()));
        Stream.concat(Stream.of(box, grabs), grips.stream().map(grip -> Box.EMPTY.with(axes.u(grip.place()), axes.v(grip.place()))))
                .filter(known -> !known.isEmpty()).forEach(known -> parts.add(view.of(known, AIR)));
        if (drag != null) {
            parts.add(Plate.besides(view, drag.figures(texts.locale()), mouse));
        }
        Bounds part = held != null || figures.areWithinBoxes(state.selection()) ? view.around(parts) : getLayoutBounds();
        selected.showOnly(held != null ? view.of(held.box, AIR) : isAlone ? part : getLayoutBounds());
        grabbed.showOnly(rays.isPresent() || (drag != null && drag.isWide()) ? getLayoutBounds() : part);
    }

    private @Nullable Held held(EditorState state) {
        List<BodyAt> bodies = Places.bodies(state.selection());
        Box box = figures.areMany(bodies) ? figures.box(bodies) : Box.EMPTY;
        return box.isEmpty() || !view.contains(box) ? null
                : new Held(state.scene(), state.selection(), bodies, state.selection().stream().filter(item -> !(item instanceof BodyAt)).toList(), view, box);
    }

    private Segment segment(Vec3 from, Vec3 to) {
        return new Segment(view.x(axes.u(from)), view.y(axes.v(from)), view.x(axes.u(to)), view.y(axes.v(to)));
    }
}
