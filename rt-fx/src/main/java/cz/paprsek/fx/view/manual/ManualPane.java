package cz.paprsek.fx.view.manual;

import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import javafx.application.Platform;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.SplitPane;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;

/** The pages beside each other's names; what is typed is looked for in all of them, and Enter goes from place to place. */
public final class ManualPane extends BorderPane {
    private final Texts texts;
    private final List<ManualPage> pages;
    private final TextField search = new TextField();
    private final ListView<ManualPage> list = new ListView<>();
    private final ScrollPane scroll = new ScrollPane();
    private final StackPane room = new StackPane();
    private final Button back = new Button("←");
    private final Deque<Place> before = new ArrayDeque<>();
    private PageView view;
    private int found = -1;

    /** @param at from 0 at the top of the page to 1 at its end */
    private record Place(ManualPage page, double at) {}

    public ManualPane(Texts texts) {
        this.texts = texts;
        this.pages = ManualPage.all(texts.locale());
        setId("manual-pane");
        getStylesheets().add(Objects.requireNonNull(ManualPane.class.getResource("manual.css")).toExternalForm());
        search.setId("manual-search");
        search.setPromptText(texts.of("manual.search"));
        search.textProperty().addListener((property, old, now) -> filter());
        search.setOnAction(event -> next());
        back.setId("manual-back");
        Hint.of(back).set(texts.of("manual.back"));
        back.setAccessibleText(texts.of("manual.back"));
        back.setOnAction(event -> back());
        back.setDisable(true);
        HBox.setHgrow(search, Priority.ALWAYS);
        HBox top = new HBox(6, back, search);
        top.setAlignment(Pos.CENTER_LEFT);
        list.setId("manual-pages");
        list.setCellFactory(cells -> new PageCell());
        list.setPlaceholder(new Label(texts.of("manual.nothing")));
        list.getItems().setAll(listed(List.of()));
        VBox.setVgrow(list, Priority.ALWAYS);
        VBox left = new VBox(6, top, list);
        left.getStyleClass().add("manual-left");
        left.setMinWidth(160);
        scroll.setId("manual-scroll");
        scroll.setFitToWidth(true);
        scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
        room.setAlignment(Pos.TOP_CENTER);
        room.getStyleClass().add("manual-room");
        scroll.setContent(room);
        SplitPane split = new SplitPane(left, scroll);
        split.setDividerPositions(0.26);
        SplitPane.setResizableWithParent(left, false);
        setCenter(split);
        begin(pages.get(0));
        list.getSelectionModel().selectedItemProperty().addListener((property, old, now) -> {
            if (now != null && !now.path().equals(path())) {
                remember();
                view = page(now);
                showFound();
            }
        });
        addEventFilter(KeyEvent.KEY_PRESSED, this::pressed);
    }

    /** The path of the page that is shown, such as "docs/editor.md". */
    public String path() {
        return String.valueOf(room.getProperties().get(ManualPage.class));
    }

    /** Shows a page of the manual, by its path; nothing happens if there is none. */
    public void show(String path) {
        pages.stream().filter(page -> page.path().equals(path)).findFirst().ifPresent(page -> go(page, ""));
    }

    /** In another language at the same page: in that language if it is there in it. */
    public ManualPane translated(Texts other) {
        ManualPane fresh = new ManualPane(other);
        if (!path().equals(pages.get(0).path())) {
            String file = path().substring(path().lastIndexOf('/'));
            fresh.pages.stream().filter(page -> page.isIn(other.locale()) && page.path().endsWith(file)).findFirst()
                    .or(() -> fresh.pages.stream().filter(page -> page.path().equals(path())).findFirst()).ifPresent(fresh::begin);
        }
        return fresh;
    }

    private void begin(ManualPage page) {
        view = page(page);
        mark(page);
    }

    /** In the list, where it may not stand. */
    private void mark(ManualPage page) {
        if (list.getItems().contains(page)) {
            list.getSelectionModel().select(page);
            list.scrollTo(page);
        } else {
            list.getSelectionModel().clearSelection();
        }
    }

    private PageView page(ManualPage page) {
        PageView fresh = new PageView(page, link -> page.resolve(link).filter(this::isPage).isPresent(), link -> follow(page, link));
        room.getChildren().setAll(fresh);
        room.getProperties().put(ManualPage.class, page.path());
        scroll.setVvalue(0);
        found = -1;
        return fresh;
    }

    private boolean isPage(String path) {
        return pages.stream().anyMatch(page -> page.path().equals(path));
    }

    private void follow(ManualPage from, String link) {
        int hash = link.indexOf('#');
        from.resolve(link).flatMap(path -> pages.stream().filter(page -> page.path().equals(path)).findFirst())
                .ifPresent(page -> go(page, hash < 0 ? "" : link.substring(hash + 1)));
    }

    private void go(ManualPage page, String anchor) {
        remember();
        if (!page.path().equals(path())) {
            view = page(page);
        }
        mark(page);
        if (!anchor.isEmpty()) {
            Platform.runLater(() -> view.anchored(anchor).ifPresent(this::reveal));
        }
    }

    private void remember() {
        pages.stream().filter(page -> page.path().equals(path())).findFirst().ifPresent(page -> before.push(new Place(page, scroll.getVvalue())));
        back.setDisable(before.isEmpty());
    }

    private void back() {
        Optional<Place> place = Optional.ofNullable(before.poll());
        back.setDisable(before.isEmpty());
        place.ifPresent(there -> {
            view = page(there.page());
            mark(there.page());
            Platform.runLater(() -> {
                room.applyCss();
                scroll.layout();
                scroll.setVvalue(there.at());
            });
        });
    }

    private List<String> words() {
        return Arrays.stream(search.getText().strip().toLowerCase(Locale.ROOT).split("\\s+")).filter(word -> !word.isEmpty()).toList();
    }

    private void filter() {
        List<String> words = words();
        List<ManualPage> having = listed(words);
        list.getItems().setAll(having);
        pages.stream().filter(page -> page.path().equals(path()) && page.has(words)).findFirst().or(() -> having.stream().findFirst()).ifPresent(this::mark);
        showFound();
    }

    /** What has the words; without any, the pages that are listed. */
    private List<ManualPage> listed(List<String> words) {
        return pages.stream().filter(page -> words.isEmpty() ? page.isListed() : page.has(words)).toList();
    }

    /** Goes to the next place of the page where something is found; after its last one, to the next page. */
    private void next() {
        int places = words().isEmpty() ? 0 : view.having(words()).size();
        if (found + 1 >= places && list.getItems().size() > 1) {
            list.getSelectionModel().select((list.getSelectionModel().getSelectedIndex() + 1) % list.getItems().size());
        } else if (places > 0) {
            found = (found + 1) % places;
            reveal(view.having(words()).get(found));
        }
    }

    private void showFound() {
        found = -1;
        view.getChildren().forEach(node -> node.getStyleClass().remove("manual-found"));
        if (words().isEmpty()) {
            return;
        }
        view.having(words()).forEach(node -> node.getStyleClass().add("manual-found"));
        Platform.runLater(() -> {
            if (found < 0 && !words().isEmpty() && !view.having(words()).isEmpty()) {
                found = 0;
                reveal(view.having(words()).get(0));
            }
        });
    }

    private void reveal(Node node) {
        scroll.applyCss();
        scroll.layout();
        double hidden = room.getHeight() - scroll.getViewportBounds().getHeight();
        double top = room.sceneToLocal(node.localToScene(node.getBoundsInLocal())).getMinY();
        scroll.setVvalue(hidden <= 0 ? 0 : Math.max(0, Math.min(1, (top - 12) / hidden)));
    }

    private void pressed(KeyEvent event) {
        if (event.isShortcutDown() && event.getCode() == KeyCode.F) {
            search.requestFocus();
            search.selectAll();
        } else if (event.isAltDown() && event.getCode() == KeyCode.LEFT) {
            back();
        } else {
            return;
        }
        event.consume();
    }

    /** A page's name; of one that is not in the language, with a sign of its own. */
    private final class PageCell extends ListCell<ManualPage> {
        PageCell() {
            // As wide as the list, so that long names are broken rather than cut.
            setPrefWidth(0);
            setWrapText(true);
        }

        @Override
        protected void updateItem(ManualPage page, boolean empty) {
            super.updateItem(page, empty);
            setText(empty || page == null ? null : page.title() + (page.isIn(texts.locale()) ? "" : "  (" + texts.of("manual.other-language") + ")"));
        }
    }
}
