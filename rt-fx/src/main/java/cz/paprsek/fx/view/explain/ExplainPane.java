package cz.paprsek.fx.view.explain;

import cz.paprsek.fx.view.PicturePoint;
import cz.paprsek.fx.view.Texts;
import cz.paprsek.drawing.DrawingFrame;
import cz.paprsek.render.explain.Outline;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.drawing.Projection;
import cz.paprsek.drawing.RayLine;
import cz.paprsek.render.explain.Step;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.geometry.Orientation;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.control.SplitPane;
import javafx.scene.control.TableColumn;
import javafx.scene.control.TableView;
import javafx.scene.control.TreeItem;
import javafx.scene.control.TreeView;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;

/**
 * Why a pixel of a picture has its colour: the tree of its rays as an outline, the chosen ray as a worked exercise, and all of them in three
 * projections. With the drawings focused, arrow keys go from pixel to pixel; the slider lets the tree grow ray by ray.
 */
public final class ExplainPane extends BorderPane {
    /** Rays of a smaller share in the pixel are left out. */
    private static final double SMALLEST_SHARE = 0.002;

    private final Texts texts;
    private final Label title = new Label();
    private final Slider grown = new Slider(1, 1, 1);
    private final TreeView<Outline> tree = new TreeView<>();
    private final TableView<Step> steps = new TableView<>();
    private final List<RayCanvas> drawings = Stream.of(Projection.values()).map(RayCanvas::new).toList();
    private final HBox drawn = new HBox(4);
    private List<Outline> outlines = List.of();
    private Optional<PicturePoint> explained = Optional.empty();

    public ExplainPane(Texts texts) {
        this.texts = texts;
        title.setId("explain-title");
        title.setText(texts.of("explain.none"));
        tree.setId("explain-tree");
        tree.setCellFactory(view -> new OutlineCell());
        tree.getSelectionModel().selectedItemProperty().addListener((property, old, now) -> select());
        steps.setId("explain-steps");
        column("explain.what", 0.22, Step::name);
        column("explain.how", 0.75, Step::equation);
        grown.setId("explain-grown");
        grown.setBlockIncrement(1);
        grown.setMajorTickUnit(1);
        grown.setMinorTickCount(0);
        grown.setSnapToTicks(true);
        grown.valueProperty().addListener((property, old, now) -> draw());
        drawings.forEach(drawing -> {
            HBox.setHgrow(drawing, Priority.ALWAYS);
            drawn.getChildren().add(drawing);
        });
        drawn.setId("explain-drawings");
        drawn.setFocusTraversable(true);
        drawn.setOnMousePressed(event -> drawn.requestFocus());
        drawn.setOnKeyPressed(this::step);
        HBox.setHgrow(grown, Priority.ALWAYS);
        HBox top = new HBox(8, title, new Label(texts.of("explain.rays")), grown);
        SplitPane parts = new SplitPane(tree, steps, drawn);
        parts.setOrientation(Orientation.VERTICAL);
        parts.setDividerPositions(0.25, 0.65);
        setId("explain-pane");
        setTop(top);
        setCenter(parts);
    }

    /** Explains the pixel at a point of a picture. */
    public void show(PicturePoint point) {
        if (explained.filter(now -> now.scene() == point.scene() && now.column() == point.column() && now.row() == point.row()).isPresent()) {
            return;
        }
        explained = Optional.of(point);
        Pixel pixel = point.scene().explain(point.settings().withSamples(1), point.column(), point.row());
        Outline root = Outline.of(pixel.rays().get(0)).pruned(SMALLEST_SHARE);
        outlines = new ArrayList<>();
        tree.setRoot(item(root));
        title.setText(texts.of("explain.pixel", point.column(), point.row()));
        grown.setMax(outlines.size());
        grown.setValue(outlines.size());
        tree.getSelectionModel().select(0);
        draw();
    }

    /** Lets arrow keys go from pixel to pixel from now on. */
    public void takeKeys() {
        drawn.requestFocus();
    }

    /** The pixel explained. */
    public Optional<PicturePoint> explained() {
        return explained;
    }

    private TreeItem<Outline> item(Outline outline) {
        outlines.add(outline);
        TreeItem<Outline> item = new TreeItem<>(outline);
        item.setExpanded(true);
        outline.children().forEach(child -> item.getChildren().add(item(child)));
        return item;
    }

    private void column(String key, double share, Function<Step, String> text) {
        TableColumn<Step, String> column = new TableColumn<>(texts.of(key));
        column.setSortable(false);
        column.setReorderable(false);
        column.setCellValueFactory(cell -> new ReadOnlyStringWrapper(text.apply(cell.getValue())));
        column.prefWidthProperty().bind(steps.widthProperty().multiply(share));
        steps.getColumns().add(column);
    }

    private Optional<Outline> selected() {
        return Optional.ofNullable(tree.getSelectionModel().getSelectedItem()).map(TreeItem::getValue);
    }

    private void select() {
        steps.getItems().setAll(selected().map(Outline::steps).orElse(List.of()));
        draw();
    }

    private void draw() {
        if (explained.isEmpty() || outlines.isEmpty()) {
            return;
        }
        Outline root = outlines.get(0);
        DrawingFrame frame = DrawingFrame.of(explained.get().scene().scene(), root);
        List<RayLine> lines = RayLine.of(root, frame.size());
        Set<String> shown = new HashSet<>();
        outlines.stream().limit(Math.round(grown.getValue())).forEach(outline -> shown.add(outline.name()));
        String highlighted = selected().map(Outline::name).orElse("");
        drawings.forEach(drawing -> drawing.draw(frame, lines, shown, highlighted));
    }

    private void step(KeyEvent event) {
        switch (event.getCode()) {
            case LEFT -> move(-1, 0);
            case RIGHT -> move(1, 0);
            case UP -> move(0, -1);
            case DOWN -> move(0, 1);
            default -> {
                return;
            }
        }
        event.consume();
    }

    private void move(int columns, int rows) {
        explained.ifPresent(from -> {
            int column = Math.max(0, Math.min(from.settings().width() - 1, from.column() + columns));
            int row = Math.max(0, Math.min(from.settings().height() - 1, from.row() + rows));
            show(new PicturePoint(from.scene(), from.settings(), column + 0.5, row + 0.5));
        });
    }
}
