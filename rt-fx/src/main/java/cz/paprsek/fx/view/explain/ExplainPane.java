package cz.paprsek.fx.view.explain;

import cz.paprsek.drawing.DrawingFrame;
import cz.paprsek.drawing.RayLine;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.rays.DrawnRays;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.text.Outline;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.words.Words;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.value.ObservableValue;
import javafx.concurrent.Task;
import javafx.geometry.Orientation;
import javafx.geometry.Pos;
import javafx.geometry.VPos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.control.SplitPane;
import javafx.scene.control.TreeItem;
import javafx.scene.control.TreeView;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/**
 * Why a pixel of a picture has its colour: the tree of its rays as an outline, and the chosen ray as a worked exercise. The slider lets the
 * tree grow ray by ray. Whoever draws the rays follows {@link #drawnProperty}.
 */
public final class ExplainPane extends BorderPane {
    /** Rays of a smaller share in the pixel are left out. */
    static final double SMALLEST_SHARE = 0.002;
    /** Up to so many levels one ray of a pixel is explained at once. */
    private static final int SHALLOW = 16;
    private static final double SLIDER = 140;

    private final Texts texts;
    private final Words words;
    private final Label title = new Label();
    private final Label message = new Label();
    /** In several rows, where the pane is narrow. */
    private final FlowPane top = new FlowPane(10, 4);
    private final Slider grown = new Slider(1, 1, 1);
    private final TreeView<Outline> tree = new TreeView<>();
    private final StepTable steps;
    private final SplitPane parts;
    private final SampleList samples;
    private final ReadOnlyObjectWrapper<Optional<DrawnRays>> drawn = new ReadOnlyObjectWrapper<>(Optional.empty());
    private BiConsumer<Scene, ScenePath.BodyAt> onChosen = (scene, surface) -> {};
    /** All rays of the tree, in the order of the rows. */
    private List<TreeItem<Outline>> rays = List.of();
    private Optional<PicturePoint> explained = Optional.empty();
    private Optional<Explained> told = Optional.empty();
    /** The pixel that is to be explained: for some of many rays that takes a while. */
    private Optional<PicturePoint> asked = Optional.empty();
    private Optional<Task<Explained>> running = Optional.empty();
    /** Whether whoever follows what is chosen is to be told as soon as the pixel is explained. */
    private boolean tells;
    /** Whether it stays at a pixel that was clicked, wherever the mouse goes. */
    private boolean pinned;
    private int ray;
    private boolean filling;

    public ExplainPane(Texts texts, ObservableValue<Theme> theme, TreeChooser chooser) {
        this.texts = texts;
        this.words = texts.words();
        this.steps = new StepTable(texts);
        title.setId("explain-title");
        title.setMinWidth(Region.USE_PREF_SIZE);
        message.setId("explain-message");
        tree.setId("explain-tree");
        tree.setCellFactory(view -> new OutlineCell(words, this::isShown));
        tree.getSelectionModel().selectedItemProperty().addListener((property, old, now) -> select());
        grown.setId("explain-grown");
        grown.setBlockIncrement(1);
        grown.setMajorTickUnit(1);
        grown.setMinorTickCount(0);
        grown.setSnapToTicks(true);
        grown.valueProperty().addListener((property, old, now) -> grow());
        grown.setPrefWidth(SLIDER);
        Label growing = new Label(texts.of("explain.rays"));
        growing.setMinWidth(Region.USE_PREF_SIZE);
        HBox shown = new HBox(10, growing, grown);
        shown.setAlignment(Pos.CENTER_LEFT);
        // A single ray leaves no choice: a slider without a thumb.
        shown.visibleProperty().bind(grown.maxProperty().greaterThan(grown.minProperty()));
        shown.managedProperty().bind(shown.visibleProperty());
        top.getChildren().addAll(title, shown, new TreeExport(this, texts, chooser, message::setText));
        top.setRowValignment(VPos.CENTER);
        top.getStyleClass().add("explain-top");
        samples = new SampleList(words);
        samples.setOnChosen(this::choose);
        parts = new SplitPane(tree, steps);
        parts.setOrientation(Orientation.VERTICAL);
        message.managedProperty().bind(message.textProperty().isNotEmpty());
        setId("explain-pane");
        getStylesheets().add(Objects.requireNonNull(ExplainPane.class.getResource("explain.css")).toExternalForm());
        setTop(top);
        setCenter(parts);
        setBottom(new VBox(message, new RayLegend(words, theme)));
        clear();
    }

    /** Adds something that can be done with the pixel. */
    public void addTool(Node tool) {
        top.getChildren().add(tool);
    }

    /** Adds the rays in three projections below, where no other window part draws them. */
    public void addDrawings(ObservableValue<Theme> theme) {
        parts.getItems().add(new RayDrawings(this, words, theme));
        divide();
    }

    /** Shares the room out: rays of the pixel if they are many, tree, exercise, drawings if they are here. */
    private void divide() {
        boolean isMany = parts.getItems().contains(samples);
        boolean isDrawn = parts.getItems().size() > (isMany ? 3 : 2);
        parts.setDividerPositions(isMany ? isDrawn ? new double[] {0.2, 0.4, 0.7} : new double[] {0.22, 0.48} : isDrawn ? new double[] {0.25, 0.65} : new double[] {0.32});
    }

    /** What drawings show now; empty before anything is explained. */
    public ReadOnlyObjectProperty<Optional<DrawnRays>> drawnProperty() {
        return drawn.getReadOnlyProperty();
    }

    /** Is told which surface a ray hits that the user chooses, and of which scene it is. */
    public void setOnChosen(BiConsumer<Scene, ScenePath.BodyAt> listener) {
        onChosen = listener;
    }

    /** Gives the keyboard to the drawings, where arrow keys go from pixel to pixel. */
    public void takeKeys() {
        parts.getItems().get(parts.getItems().size() - 1).requestFocus();
    }

    /** The pixel explained. */
    public Optional<PicturePoint> explained() {
        return explained;
    }

    /** The mouse is at a point of a picture: explains it unless another pixel was clicked. */
    public void hover(Optional<PicturePoint> point) {
        if (!pinned) {
            point.ifPresent(this::show);
        }
    }

    /** Stays at a pixel, for arrow keys to go on from there; the next click lets the explanation follow the mouse again. */
    public void click(PicturePoint point) {
        pinned = !pinned;
        show(point);
        if (pinned) {
            tells = running.isPresent();
            if (!tells) {
                tellChosen();
            }
        }
    }

    /** Explains the pixel at a point of a picture. */
    public void show(PicturePoint point) {
        if (asked.filter(now -> now.scene() == point.scene() && now.settings().equals(point.settings())
                && now.column() == point.column() && now.row() == point.row()).isPresent()) {
            return;
        }
        asked = Optional.of(point);
        running.ifPresent(Task::cancel);
        running = Optional.empty();
        if (point.settings().mostRays() == 1 && point.settings().maxDepth() <= SHALLOW) {
            show(point, Explained.of(point));
        } else {
            explain(point);
        }
    }

    /** In the background, as the rays of a pixel may be thousands, until something else is asked for. */
    private void explain(PicturePoint point) {
        Task<Explained> task = new Task<>() {
            @Override
            protected Explained call() {
                return Explained.of(point);
            }
        };
        running = Optional.of(task);
        task.setOnSucceeded(event -> end(task, () -> show(point, task.getValue())));
        task.setOnFailed(event -> end(task, () -> message.setText(String.valueOf(task.getException().getMessage()))));
        Thread thread = new Thread(task, "paprsek-explain");
        thread.setDaemon(true);
        thread.start();
    }

    private void end(Task<Explained> task, Runnable then) {
        if (running.equals(Optional.of(task))) {
            running = Optional.empty();
            then.run();
        }
    }

    private void show(PicturePoint point, Explained fresh) {
        explained = Optional.of(point);
        told = Optional.of(fresh);
        message.setText(fresh.size() == 0 ? texts.of("explain.dark") : "");
        title.setText(texts.of("explain.pixel", point.column(), point.row()));
        boolean isMany = fresh.size() > 1 || point.settings().isPath();
        if (isMany && !parts.getItems().contains(samples)) {
            parts.getItems().add(0, samples);
            divide();
        } else if (!isMany && parts.getItems().remove(samples)) {
            divide();
        }
        if (isMany) {
            samples.show(fresh, fresh.typical());
        }
        if (fresh.size() > 0) {
            choose(fresh.typical());
        } else {
            forgetRays();
        }
        if (tells) {
            tells = false;
            tellChosen();
        }
    }

    /** Shows the tree of one of the pixel's rays. */
    private void choose(int sample) {
        ray = sample;
        Explained pixel = told.orElseThrow();
        Outline root = Outline.of(pixel.ray(sample)).pruned(pixel.smallestShare());
        rays = new ArrayList<>();
        filling = true;
        tree.setRoot(item(root));
        grown.setMax(rays.size());
        grown.setValue(rays.size());
        tree.getSelectionModel().select(0);
        filling = false;
        select();
    }

    /** Forgets the pixel. */
    public void clear() {
        explained = Optional.empty();
        told = Optional.empty();
        asked = Optional.empty();
        parts.getItems().remove(samples);
        divide();
        pinned = false;
        title.setText(texts.of("explain.none"));
        forgetRays();
    }

    private void forgetRays() {
        rays = List.of();
        grown.setMax(grown.getMin());
        tree.setRoot(null);
        steps.getItems().clear();
        draw();
    }

    /** Goes to the next pixel if an arrow key was pressed. */
    public void step(KeyEvent event) {
        if (asked.isEmpty() || event.isShortcutDown() || event.isAltDown() || event.isShiftDown()) {
            return;
        }
        switch (event.getCode()) {
            case LEFT -> move(-1, 0);
            case RIGHT -> move(1, 0);
            case UP -> move(0, -1);
            case DOWN -> move(0, 1);
            default -> {
                return;
            }
        }
        pinned = true;
        event.consume();
    }

    /** What is told of the pixel. */
    Optional<Explained> told() {
        return told;
    }

    /** What is explained, if it is a pixel of rays: all of them. */
    Optional<Pixel> pixel() {
        return told.filter(Explained.OfRays.class::isInstance).map(pixel -> ((Explained.OfRays) pixel).pixel());
    }

    /** Which of the pixel's rays is chosen, counted from 0. */
    int ray() {
        return ray;
    }

    private TreeItem<Outline> item(Outline outline) {
        TreeItem<Outline> item = new TreeItem<>(outline);
        rays.add(item);
        item.setExpanded(true);
        outline.children().forEach(child -> item.getChildren().add(item(child)));
        return item;
    }

    private Optional<Outline> selected() {
        return Optional.ofNullable(tree.getSelectionModel().getSelectedItem()).map(TreeItem::getValue);
    }

    private void select() {
        if (!filling) {
            steps.getItems().setAll(selected().map(outline -> outline.steps(words)).orElse(List.of()));
            draw();
            if (tree.isFocused()) {
                tellChosen();
            }
        }
    }

    /** The rays grown to: the newest is chosen, so that its exercise is beside it, those to come are faint. */
    private void grow() {
        if (!filling && !rays.isEmpty()) {
            tree.getSelectionModel().select(rays.get(count() - 1));
            draw();
            tree.refresh();
        }
    }

    private boolean isShown(Outline outline) {
        return drawn.get().map(now -> now.shown().contains(outline.name())).orElse(true);
    }

    private int count() {
        return (int) Math.round(grown.getValue());
    }

    private void tellChosen() {
        selected().flatMap(outline -> outline.ray().encounter()).map(Encounter::place).map(Encounter.Place::surface)
                .ifPresent(surface -> explained.ifPresent(point -> onChosen.accept(point.scene().scene(), surface.part())));
    }

    private void draw() {
        if (filling) {
            return;
        }
        drawn.set(explained.filter(point -> !rays.isEmpty()).map(point -> {
            Outline root = rays.get(0).getValue();
            Optional<DrawnRays> before = drawn.get();
            DrawingFrame frame = DrawingFrame.of(point.scene().scene(), root);
            return new DrawnRays(before.map(DrawnRays::frame).filter(frame::equals).orElse(frame), RayLine.of(root, frame.size()),
                    rays.stream().limit(count()).map(ray -> ray.getValue().name()).collect(Collectors.toSet()),
                    selected().map(Outline::name).orElse(""));
        }));
    }

    private void move(int columns, int rows) {
        asked.ifPresent(from -> {
            int column = Math.max(0, Math.min(from.settings().width() - 1, from.column() + columns));
            int row = Math.max(0, Math.min(from.settings().height() - 1, from.row() + rows));
            show(new PicturePoint(from.scene(), from.settings(), column + 0.5, row + 0.5));
        });
    }
}
