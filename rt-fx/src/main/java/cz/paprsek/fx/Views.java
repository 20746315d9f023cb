package cz.paprsek.fx;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.contact.Dropping;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.fx.model.edit.Cameras;
import cz.paprsek.fx.model.edit.CutPlane;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.fx.view.camera.CameraPane;
import cz.paprsek.fx.view.camera.FreeCommands;
import cz.paprsek.fx.view.command.CameraCommands;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.command.Pipette;
import cz.paprsek.fx.view.command.SelectionCommands;
import cz.paprsek.fx.view.explain.ExplainMode;
import cz.paprsek.fx.view.explain.ExplainPane;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.motion.OnionSkin;
import cz.paprsek.fx.view.motion.TimelinePane;
import cz.paprsek.fx.view.picture.Framing;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.projection.Axes;
import cz.paprsek.fx.view.projection.ProjectionPane;
import cz.paprsek.fx.view.section.SectionSkin;
import cz.paprsek.fx.view.shell.AddPalette;
import cz.paprsek.fx.view.shell.AddPalette.Place;
import cz.paprsek.fx.view.shell.PaneGrid;
import cz.paprsek.fx.view.shell.TitledView;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.Tile;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.InvalidationListener;
import javafx.beans.WeakInvalidationListener;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.ObservableValue;
import javafx.beans.value.WeakChangeListener;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;

/** The four views, and where they look. */
final class Views {
    private final EditorModel model;
    private final ObservableValue<Theme> theme;
    private final List<ProjectionPane> projections;
    private final CameraPane camera;
    private final List<TitledView> titled;
    private final PaneGrid grid;
    private final TimelinePane timeline;
    private final VBox root;
    private final ExplainMode explaining;
    private final CameraCommands cameras;
    private final CameraPane free;
    private final TitledView freeView;
    private final FreeCommands freeCommands;
    private final ObjectProperty<Optional<CutPlane>> cut = new SimpleObjectProperty<>(Optional.empty());
    private final BooleanProperty freeShown = new SimpleBooleanProperty();
    /** How many scenes had been opened when the free view was shown. */
    private int freeOpenings = -1;
    /** Held here, because the model, which may outlive the views, holds them weakly. */
    private final ChangeListener<Object> onOpened = (property, old, now) -> opened();
    private final InvalidationListener onState = changed -> aimFree();
    /** Held here likewise: what was said of a part is past when there is another, or none any more. */
    private final ChangeListener<Framing> onFraming;
    private final Runnable present;
    private Node last;
    private Optional<ProjectionPane> active = Optional.empty();

    Views(Editor editor, SelectionCommands commands) {
        this.model = editor.model();
        this.theme = editor.followTheme();
        Texts texts = editor.texts();
        camera = new CameraPane(model, editor::fault);
        camera.follow(editor.clock());
        camera.setOnLocked(() -> editor.say(texts.of("view.camera-locked")));
        ProjectionPane top = projection(editor, commands.edits(), Axes.TOP);
        ProjectionPane front = projection(editor, commands.edits(), Axes.FRONT);
        ProjectionPane right = projection(editor, commands.edits(), Axes.RIGHT);
        projections = List.of(top, front, right);
        titled = List.of(
                titled("top", texts.of("view.top"), texts, top), titled("camera", texts.of("view.camera"), texts, camera),
                titled("front", texts.of("view.front"), texts, front), titled("right", texts.of("view.right"), texts, right));
        grid = new PaneGrid(titled);
        OnionSkin skin = new OnionSkin(model, editor.clock());
        projections.forEach(pane -> pane.follow(editor.clock(), skin));
        timeline = new TimelinePane(commands.edits(), editor.clock(), theme);
        VBox.setVgrow(grid, Priority.ALWAYS);
        root = new VBox(grid, timeline);
        root.setMinWidth(0);
        explaining = new ExplainMode(model, camera, projections, new ExplainPane(texts, theme, editor.treeChooser()));
        present = () -> editor.presenter().show(explaining.pane().explained());
        explaining.pane().addTool(presentButton(texts));
        cameras = new CameraCommands(commands.edits(), () -> focus(editor));
        titled.get(1).addChooser(cameras.chooser());
        titled.get(1).addFoldingTool(explainButton(texts));
        camera.acceptMaterials(commands.edits());
        camera.acceptEdits(commands.edits(), editor.snapping());
        camera.acceptRegions(editor.renders().framing(), part -> {
            editor.renders().setRegion(part);
            part.ifPresentOrElse(tile -> editor.say(ofPart(tile, texts)), () -> editor.unsay(texts.of("view.region-drag")));
        });
        onFraming = (property, old, now) -> old.part().filter(tile -> !now.part().equals(old.part())).ifPresent(tile -> editor.unsay(ofPart(tile, texts)));
        editor.renders().framing().addListener(new WeakChangeListener<>(onFraming));
        projections.forEach(ProjectionPane::acceptMaterials);
        camera.setContextMenu(commands.contextMenu());
        projections.forEach(pane -> pane.setContextMenu(commands.contextMenu()));
        free = CameraPane.free(model, editor::fault);
        free.follow(editor.clock());
        free.acceptMaterials(commands.edits());
        SectionSkin section = new SectionSkin(model, cut);
        projections.forEach(pane -> pane.cutBy(section));
        camera.cutBy(cut);
        free.cutBy(cut);
        commands.setOnBlink(() -> List.of(camera, free).forEach(pane -> pane.blink(model.selection())));
        free.acceptEdits(commands.edits(), editor.snapping());
        free.setContextMenu(commands.contextMenu());
        takeMaterials(editor, commands.edits().pipette());
        freeView = titled("free", texts.of("view.free"), texts, free);
        freeCommands = new FreeCommands(commands.edits(), free, () -> freeShown.set(true), () -> editor.say(texts.of("view.camera-locked")));
        freeView.addTool(freeButton(texts));
        freeShown.addListener((property, old, now) -> showFree(now));
        model.openingsProperty().addListener(new WeakChangeListener<>(onOpened));
        model.stateProperty().addListener(new WeakInvalidationListener(onState));
        free.focusWithinProperty().addListener((property, old, now) -> last = now ? free : last);
        last = camera;
        for (TitledView view : titled) {
            view.content().focusWithinProperty().addListener((property, old, now) -> last = now ? view.content() : last);
        }
        for (ProjectionPane pane : projections) {
            pane.focusedProperty().addListener((property, old, now) -> active = now ? Optional.of(pane) : active);
        }
    }

    /** What was asked for is of the scene before. */
    private void opened() {
        whole();
        List.of(camera, free).forEach(CameraPane::freeMouse);
    }

    /** Gives up what the mouse was asked for in whatever view, as Escape does wherever the keyboard is; whether there was anything. */
    boolean giveUp() {
        return camera.giveUp() || free.giveUp();
    }

    private static String ofPart(Tile part, Texts texts) {
        return texts.of("view.region-done", part.x(), part.y(), part.width(), part.height());
    }

    private ProjectionPane projection(Editor editor, Edits edits, Axes axes) {
        ProjectionPane pane = new ProjectionPane(edits, axes, theme, editor.snapping(), editor.proportional());
        pane.setId("projection-" + axes.name().toLowerCase(Locale.ROOT));
        return pane;
    }

    private static TitledView titled(String name, String caption, Texts texts, Node content) {
        return new TitledView(name, caption, texts.of("view.maximize"), content);
    }

    private ToggleButton explainButton(Texts texts) {
        ToggleButton button = new ToggleButton(texts.of("explain.mode"), new FontIcon(MaterialDesignC.CHART_TIMELINE_VARIANT));
        button.setId("camera-explain");
        button.getStyleClass().add("view-button");
        Hint.of(button).set(texts.of("explain.hint"));
        button.setFocusTraversable(false);
        button.selectedProperty().bindBidirectional(explaining.onProperty());
        return button;
    }

    private MenuButton freeButton(Texts texts) {
        MenuButton button = new MenuButton("", new FontIcon(MaterialDesignC.CUBE_SCAN));
        button.setId("free-looks");
        button.getStyleClass().add("view-button");
        button.setFocusTraversable(false);
        Hint.of(button).set(texts.of("free.menu"));
        button.setAccessibleText(texts.of("free.menu"));
        List<MenuItem> items = freeCommands.items();
        items.forEach(item -> item.setId("title-" + item.getId()));
        button.getItems().setAll(items);
        return button;
    }

    /** A free view in the place of the one from the right, below the camera's. */
    BooleanProperty freeShownProperty() {
        return freeShown;
    }

    /** What is done with the free view. */
    List<MenuItem> freeItems() {
        return freeCommands.items();
    }

    /** Cuts solids open across an axis, in the middle. */
    void cut(Axis axis) {
        cut.set(Optional.of(new CutPlane(axis, 0.5)));
    }

    void whole() {
        cut.set(Optional.empty());
    }

    /** Moves the plane that solids are cut by, by a share of what there is. */
    void moveCut(double by) {
        cut.set(cut.get().map(plane -> new CutPlane(plane.axis(), plane.share() + by)));
    }

    /** Looks by the camera of a scene that has been opened since. */
    private void aimFree() {
        if (freeShown.get() && freeOpenings != model.openingsProperty().get()) {
            freeOpenings = model.openingsProperty().get();
            free.look(old -> model.state().camera());
        }
    }

    private void showFree(boolean isShown) {
        aimFree();
        grid.replace(isShown ? titled.get(3) : freeView, isShown ? freeView : titled.get(3));
    }

    private Button presentButton(Texts texts) {
        Button button = new Button(texts.of("explain.present"));
        button.setId("explain-present");
        Hint.of(button).set(texts.of("explain.present-hint"));
        button.setMinWidth(Region.USE_PREF_SIZE);
        button.setOnAction(event -> present());
        return button;
    }

    /** Explains the pixel, or the one in the middle, before a class. */
    void present() {
        present.run();
    }

    /** Through which camera the user looks. */
    CameraCommands cameras() {
        return cameras;
    }

    /** A click in any view is for the pipette as long as that is held. */
    private void takeMaterials(Editor editor, Pipette pipette) {
        Texts texts = editor.texts();
        pipette.activeProperty().addListener((property, old, now) -> {
            List.of(free, camera).forEach(now ? pane -> await(pane, pipette) : CameraPane::freeMouse);
            projections.forEach(pane -> pane.setCursor(now ? Cursor.CROSSHAIR : Cursor.DEFAULT));
            if (now) {
                editor.say(texts.of("view.pipette-click"));
            } else {
                pipette.taken().ifPresentOrElse(from -> editor.say(texts.of("view.pipette-done", PathNames.of(model.scene(), from, texts))), () -> editor.unsay(texts.of("view.pipette-click")));
            }
        });
    }

    /** Until a body is clicked. */
    private static void await(CameraPane pane, Pipette pipette) {
        pane.awaitClick(point -> {
            pipette.take(pane.body(point));
            if (pipette.isActive()) {
                await(pane, pipette);
            }
        }, pipette::cancel);
    }

    /** Asks for a click into the picture of the camera: on what shall be sharp. */
    private void focus(Editor editor) {
        camera.awaitClick(point -> point.pick().ifPresentOrElse(
                pick -> {
                    int eye = model.state().eye();
                    model.edit(Label.of(Label.Edit.CAMERA), scene -> Cameras.focused(scene, eye, pick.point()));
                    editor.say(editor.texts().of("view.focus-done", PathNames.of(point.scene().scene(), pick.place(), editor.texts())));
                },
                () -> editor.say(editor.texts().of("view.focus-nothing"))), () -> editor.unsay(editor.texts().of("view.focus-click")));
        editor.say(editor.texts().of("view.focus-click"));
    }

    /** Has the next drag in the camera's picture draw the part that is rendered alone. */
    void drawRegion() {
        grid.maximizedProperty().get().filter(view -> view != titled.get(1)).ifPresent(grid::toggle);
        camera.drawRegion();
    }

    /** Explains pixels of the camera's picture. */
    ExplainMode explaining() {
        return explaining;
    }

    Node root() {
        return root;
    }

    /** The four views without the timeline. */
    Node grid() {
        return grid;
    }

    /** Times and keys of what is animated. */
    TimelinePane timeline() {
        return timeline;
    }

    /** The views in the order of the window: top, camera, front, right. */
    List<TitledView> titled() {
        return titled;
    }

    /** Gives the keyboard to the view that had it last. */
    void takeKeys() {
        last.requestFocus();
    }

    void toggle(TitledView view) {
        if (view == titled.get(3)) {
            freeShown.set(false);
        }
        grid.toggle(view);
    }

    /** Does something with the projection used last, or with all if none was. */
    void zoom(Consumer<ProjectionPane> change) {
        active.ifPresentOrElse(change, () -> projections.forEach(change));
    }

    void fitAll() {
        projections.forEach(ProjectionPane::fitAll);
    }

    void fitSelection() {
        projections.forEach(ProjectionPane::fitSelection);
    }

    /** Tells where the mouse is in the world, in words; empty if it is in no projection. */
    void setOnPointed(Consumer<String> listener, Texts texts) {
        for (ProjectionPane pane : projections) {
            pane.pointedProperty().addListener((property, old, now) -> listener.accept(now.map(p -> pane.describe(p, texts.locale())).orElse("")));
        }
    }

    /** Where new things are put: in the middle of the projection used last, at the depth of what the camera looks at. */
    Sight sight() {
        Sight gaze = Sight.of(model.state());
        return active.map(pane -> pane.sight(gaze.point())).orElse(gaze);
    }

    /**
     * Lets what is dragged out of the palette be put into each view: in the camera's on what is under the mouse, from above on what is below, in a room on its floor, else where it is
     * dropped; in projections, however near they are, as large as where the camera looks.
     */
    void acceptThings(AddPalette palette, BooleanProperty snapping) {
        projections.forEach(pane -> palette.dropOn(pane, event -> {
            Sight at = pane.sightAt(event.getX(), event.getY(), Sight.of(model.state()));
            double top = Dropping.top(model.state(), at.point().x(), at.point().z());
            return pane == projections.get(0) ? place(new Sight(new Vec3(at.point().x(), top, at.point().z()), at.size()), Vec3.Y) : new Place(at, Vec3.ZERO);
        }));
        List.of(camera, free).forEach(pane -> palette.dropOn(pane, event -> pane.pointAt(event.getX(), event.getY()).flatMap(point -> seen(pane, point, snapping))
                .orElseGet(() -> place(Sight.of(model.state()), Vec3.Y))));
    }

    private Optional<Place> seen(CameraPane pane, PicturePoint point, BooleanProperty snapping) {
        return point.pick().map(pick -> place(Sight.chosen(pick.point(), point.side(), pane.camera().lens().heightAt(pick.distance()), snapping.get()), point.side()));
    }

    private Place place(Sight sight, Vec3 side) {
        return new Place(Dropping.fitting(model.state(), sight, side), side);
    }

    boolean isPictureComplete() {
        return camera.isComplete();
    }

    void close() {
        camera.close();
        free.close();
        timeline.close();
    }
}
