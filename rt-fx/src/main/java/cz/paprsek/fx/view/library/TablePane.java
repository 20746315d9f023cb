package cz.paprsek.fx.view.library;

import cz.paprsek.fx.model.library.Library;
import cz.paprsek.fx.model.library.LibraryRows;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.query.Column;
import cz.paprsek.query.Relation;
import cz.paprsek.query.SceneTables;
import cz.paprsek.query.Table;
import cz.paprsek.query.Value;
import cz.paprsek.query.text.TableText;
import cz.paprsek.scene.Scene;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javafx.application.Platform;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.StringProperty;
import javafx.scene.control.Label;
import javafx.scene.control.TableCell;
import javafx.scene.control.TableColumn;
import javafx.scene.control.TableRow;
import javafx.scene.control.TableView;
import javafx.scene.layout.BorderPane;
import javafx.scene.text.Text;
import org.jspecify.annotations.Nullable;

/** Everything of one kind in all scenes, as a table to be sorted by any column. */
final class TablePane extends BorderPane implements AutoCloseable {
    /** Titles of columns are bold. */
    private static final double TITLE_SCALE = 1.15;
    /** Beside a title, for the arrow of what is sorted, pixels. */
    private static final double TITLE_ROOM = 36;

    private final Library library;
    private final Executor searcher;
    private final StringProperty filter;
    private final Texts texts;
    private final TableWords words;
    private final Label problem;
    private final Supplier<Label> placeholder;
    private final Consumer<String> onOpen;
    private final Consumer<Integer> onCount;
    private @Nullable LibraryRows<?> current;
    private Supplier<Stream<String>> csv = Stream::empty;
    private Supplier<Stream<String>> json = Stream::empty;

    /**
     * @param problem where it is said what is wrong with the filter
     * @param placeholder says why there is no row
     * @param onOpen is told the scene of a row that is clicked twice
     * @param onCount is told how many rows there are
     */
    TablePane(Library library, Executor searcher, StringProperty filter, Texts texts, Label problem, Supplier<Label> placeholder, Consumer<String> onOpen, Consumer<Integer> onCount) {
        this.library = library;
        this.searcher = searcher;
        this.filter = filter;
        this.texts = texts;
        this.words = new TableWords(texts);
        this.problem = problem;
        this.placeholder = placeholder;
        this.onOpen = onOpen;
        this.onCount = onCount;
    }

    /** Shows the table of that name. */
    void show(String table) {
        show(SceneTables.named(table));
    }

    private <R> void show(Relation<Scene, R> relation) {
        close();
        LibraryRows<R> rows = new LibraryRows<>(library, relation, words::cell, searcher, Platform::runLater);
        current = rows;
        List<Column<R>> columns = relation.table().columns();
        TableView<R> view = new TableView<>();
        view.setId("table");
        view.setFixedCellSize(24);
        view.setPlaceholder(placeholder.get());
        columns.forEach(column -> view.getColumns().add(column(column)));
        view.setRowFactory(made -> row(relation.table()));
        view.setSortPolicy(sorted -> {
            rows.sort(sorted.getSortOrder().stream().map(column -> order(columns, column)).toList());
            return true;
        });
        rows.filterProperty().bind(filter);
        rows.rowsProperty().subscribe(found -> {
            // Another list would make the view forget what it is sorted by.
            view.getItems().setAll(found);
            view.setPlaceholder(placeholder.get());
            onCount.accept(found.size());
        });
        problem.textProperty().bind(rows.problemProperty().map(texts::sentence));
        csv = () -> TableText.csv(columns, rows.rows());
        json = () -> TableText.json(columns, rows.rows());
        setCenter(view);
    }

    /** Says anew why there is no row. */
    void sayWhy() {
        if (getCenter() instanceof TableView<?> view) {
            view.setPlaceholder(placeholder.get());
        }
    }

    /** What is shown, all of it and in its order, for another program. */
    Stream<String> csv() {
        return csv.get();
    }

    /** As {@link #csv}, in another form. */
    Stream<String> json() {
        return json.get();
    }

    @Override
    public void close() {
        if (current != null) {
            current.close();
        }
        current = null;
        csv = Stream::empty;
        json = Stream::empty;
        setCenter(null);
    }

    private static <R> LibraryRows.Order<R> order(List<Column<R>> columns, TableColumn<R, ?> sorted) {
        Column<R> column = columns.stream().filter(each -> each.name().equals(sorted.getId())).findFirst().orElseThrow();
        return new LibraryRows.Order<>(column, sorted.getSortType() == TableColumn.SortType.ASCENDING);
    }

    private <R> TableColumn<R, Value> column(Column<R> column) {
        TableColumn<R, Value> made = new TableColumn<>();
        made.setId(column.name());
        Label title = new Label(words.column(column.name()));
        Hint.of(title).set(texts.of("library.in-filter", column.name()));
        made.setGraphic(title);
        // For who reads the screen aloud; what is seen is the graphic, which has the hint.
        made.setText(title.getText());
        boolean isNumber = column.type() == Column.Type.NUMBER;
        made.setPrefWidth(Math.max(width(column), new Text(title.getText()).getLayoutBounds().getWidth() * TITLE_SCALE + TITLE_ROOM));
        made.setCellValueFactory(row -> new ReadOnlyObjectWrapper<>(column.cell(row.getValue())));
        made.setCellFactory(view -> new TableCell<>() {
            @Override
            protected void updateItem(Value value, boolean empty) {
                super.updateItem(value, empty);
                setText(empty || value == null ? "" : words.cell(column, value));
            }
        });
        made.setStyle(isNumber ? "-fx-alignment: CENTER-RIGHT" : "-fx-alignment: CENTER-LEFT");
        return made;
    }

    private static double width(Column<?> column) {
        return switch (column.type()) {
            case NUMBER -> 90;
            case VECTOR -> 220;
            case COLOR -> 140;
            case TEXT -> column.name().equals("description") ? 400 : column.name().equals("path") ? 200 : 140;
        };
    }

    private <R> TableRow<R> row(Table<R> table) {
        TableRow<R> row = new TableRow<>();
        row.setOnMouseClicked(event -> {
            if (event.getClickCount() == 2 && !row.isEmpty()) {
                onOpen.accept(scene(table, row.getItem()));
            }
        });
        row.setOnDragDetected(event -> {
            if (!row.isEmpty()) {
                dragged(table, row.getItem()).ifPresent(scene -> LibraryDrag.start(row, scene, Optional.empty()));
                event.consume();
            }
        });
        return row;
    }

    /** What is taken along by the mouse: a scene, or a scene of one material. */
    private <R> Optional<Scene> dragged(Table<R> table, R row) {
        Optional<Scene> scene = library.database().find(scene(table, row));
        if (!table.name().equals("material")) {
            return table.name().equals("scene") ? scene : Optional.empty();
        }
        String name = text(table, "name", row);
        return scene.map(from -> Scene.EMPTY.plus(name, from.materials().getOrDefault(name, Material.DEFAULT)));
    }

    private static <R> String scene(Table<R> table, R row) {
        return text(table, table.ownColumn("scene").isPresent() ? "scene" : "name", row);
    }

    private static <R> String text(Table<R> table, String column, R row) {
        return table.ownColumn(column).map(found -> found.cell(row).text()).orElse("");
    }
}
