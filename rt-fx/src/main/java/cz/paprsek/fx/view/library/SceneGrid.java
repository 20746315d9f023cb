package cz.paprsek.fx.view.library;

import cz.paprsek.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.collections.FXCollections;
import javafx.scene.Node;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;

/** Scenes as tiles, as many in a row as there is room for; only rows that can be seen are made. By mouse and by keys. */
final class SceneGrid extends ListView<List<Scene>> {
    private static final double SCROLL_BAR = 20;

    private final Thumbnails thumbnails;
    private final SceneSelection selection;
    private final Consumer<String> onOpen;
    private final List<Row> rows = new ArrayList<>();
    private List<Scene> scenes = List.of();
    private int perRow = 1;

    SceneGrid(Thumbnails thumbnails, SceneSelection selection, Consumer<String> onOpen) {
        this.thumbnails = thumbnails;
        this.selection = selection;
        this.onOpen = onOpen;
        setId("library-scenes");
        getStyleClass().add("scene-grid");
        setFixedCellSize(SceneTile.HEIGHT);
        setCellFactory(view -> new Row());
        widthProperty().addListener((property, old, width) -> {
            int fitting = Math.max(1, (int) ((width.doubleValue() - SCROLL_BAR) / SceneTile.WIDTH));
            if (fitting != perRow) {
                perRow = fitting;
                arrange();
            }
        });
        selection.namesProperty().addListener((property, old, names) -> rows.forEach(Row::showSelection));
        addEventFilter(MouseEvent.MOUSE_PRESSED, this::pressed);
        addEventFilter(MouseEvent.MOUSE_RELEASED, this::released);
        addEventFilter(KeyEvent.KEY_PRESSED, this::key);
        setOnDragDetected(event -> tile(event).flatMap(SceneTile::scene).ifPresent(scene -> {
            LibraryDrag.start(this, scene, thumbnails.get(scene).flatMap(Thumbnails.Picture::image));
            event.consume();
        }));
    }

    /** Shows these scenes. */
    void show(List<Scene> shown) {
        scenes = shown;
        selection.show(shown);
        arrange();
    }

    private void arrange() {
        List<List<Scene>> lines = new ArrayList<>();
        for (int i = 0; i < scenes.size(); i += perRow) {
            lines.add(scenes.subList(i, Math.min(i + perRow, scenes.size())));
        }
        setItems(FXCollections.observableList(lines));
    }

    private void pressed(MouseEvent event) {
        requestFocus();
        Optional<String> name = tile(event).flatMap(SceneTile::scene).map(Scene::name);
        if (name.isEmpty()) {
            return;
        }
        event.consume();
        if (event.isShiftDown()) {
            selection.extend(name.get());
        } else if (event.isShortcutDown()) {
            selection.toggle(name.get());
        } else if (!selection.names().contains(name.get())) {
            selection.only(name.get());
        }
    }

    private void released(MouseEvent event) {
        Optional<String> name = tile(event).flatMap(SceneTile::scene).map(Scene::name);
        if (name.isEmpty() || event.getButton() != MouseButton.PRIMARY || !event.isStillSincePress() || event.isShiftDown() || event.isShortcutDown()) {
            return;
        }
        selection.only(name.get());
        if (event.getClickCount() == 2) {
            onOpen.accept(name.get());
        }
    }

    private void key(KeyEvent event) {
        int place = selection.leadPlace();
        int page = Math.max(1, (int) (getHeight() / SceneTile.HEIGHT)) * perRow;
        switch (event.getCode()) {
            case LEFT -> go(event, place - 1);
            case RIGHT -> go(event, place + 1);
            case UP -> go(event, place - perRow);
            case DOWN -> go(event, place < 0 ? 0 : place + perRow);
            case PAGE_UP -> go(event, place - page);
            case PAGE_DOWN -> go(event, place + page);
            case HOME -> go(event, 0);
            case END -> go(event, scenes.size() - 1);
            case ENTER -> {
                selection.names().stream().findFirst().ifPresent(onOpen);
                event.consume();
            }
            default -> {
                if (event.getCode() == KeyCode.A && event.isShortcutDown()) {
                    selection.all();
                    event.consume();
                }
            }
        }
    }

    private void go(KeyEvent event, int place) {
        event.consume();
        if (scenes.isEmpty()) {
            return;
        }
        int inside = Math.max(0, Math.min(place, scenes.size() - 1));
        String name = scenes.get(inside).name();
        if (event.isShiftDown()) {
            selection.extend(name);
        } else {
            selection.only(name);
        }
        reveal(inside);
    }

    /** Scrolls to a scene only if it cannot be seen whole. */
    void reveal(int place) {
        int line = place / perRow;
        boolean isSeen = rows.stream().anyMatch(row -> !row.isEmpty() && row.getIndex() == line
                && row.getLayoutY() >= 0 && row.getLayoutY() + row.getHeight() <= getHeight());
        if (!isSeen) {
            scrollTo(line);
        }
    }

    private static Optional<SceneTile> tile(MouseEvent event) {
        for (Node node = event.getPickResult().getIntersectedNode(); node != null; node = node.getParent()) {
            if (node instanceof SceneTile tile) {
                return Optional.of(tile);
            }
        }
        return Optional.empty();
    }

    /** A line of tiles. */
    private final class Row extends ListCell<List<Scene>> {
        private final HBox tiles = new HBox();

        Row() {
            rows.add(this);
            setPrefWidth(0);
            getStyleClass().add("scene-row");
        }

        @Override
        protected void updateItem(List<Scene> line, boolean empty) {
            super.updateItem(line, empty);
            int count = empty || line == null ? 0 : line.size();
            while (tiles.getChildren().size() < count) {
                tiles.getChildren().add(new SceneTile(thumbnails));
            }
            for (int i = 0; i < tiles.getChildren().size(); i++) {
                tile(i).show(i < count && line != null ? Optional.of(line.get(i)) : Optional.empty(), selection);
            }
            setGraphic(count == 0 ? null : tiles);
        }

        void showSelection() {
            for (int i = 0; i < tiles.getChildren().size(); i++) {
                tile(i).showSelection(selection);
            }
        }

        private SceneTile tile(int place) {
            return (SceneTile) tiles.getChildren().get(place);
        }
    }
}
