package cz.paprsek.fx.view.welcome;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.view.library.Thumbnails;
import cz.paprsek.fx.view.library.Worker;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import javafx.application.Platform;
import javafx.beans.value.ChangeListener;
import javafx.event.EventHandler;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.control.OverrunStyle;
import javafx.scene.control.ScrollPane;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;

/**
 * Where to begin: the tour, something new, the files of last time and the scenes that are shipped, as pictures. Above everything, until something is chosen,
 * Escape is pressed, there is a click beside it, or the keyboard goes elsewhere.
 */
public final class WelcomePane extends StackPane {
    private static final double WIDTH = 1000;
    private static final double HEIGHT = 680;
    private static final double LEFT = 230;
    /** Of a picture on the screen, pixels. */
    private static final double TILE = 150;

    private final Texts texts;
    private final HBox box = new HBox(16);
    private final VBox actions = new VBox(6);
    private final VBox pictures = new VBox(8);
    private final CheckBox atStart;
    private final List<Node> stops = new ArrayList<>();
    private Optional<Node> before = Optional.empty();
    private Optional<ExecutorService> reader = Optional.empty();
    private Optional<Thumbnails> thumbnails = Optional.empty();
    private final ChangeListener<Node> onFocus = (property, old, now) -> {
        if (now != null && !isInside(now)) {
            close();
        }
    };

    /** Of the whole window: at the start the keyboard may be nowhere yet. */
    private final EventHandler<KeyEvent> onKey = this::pressed;

    public WelcomePane(Texts texts) {
        this.texts = texts;
        setId("welcome");
        getStyleClass().add("welcome-room");
        getStylesheets().add(Objects.requireNonNull(WelcomePane.class.getResource("welcome.css")).toExternalForm());
        atStart = new CheckBox(texts.of("welcome.at-start"));
        atStart.setId("welcome-at-start");
        atStart.setWrapText(true);
        atStart.setMinHeight(Region.USE_PREF_SIZE);
        actions.setMinWidth(LEFT);
        actions.setMaxWidth(LEFT);
        ScrollPane scroll = new ScrollPane(pictures);
        scroll.setId("welcome-scroll");
        scroll.setFitToWidth(true);
        scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
        scroll.setFocusTraversable(false);
        HBox.setHgrow(scroll, Priority.ALWAYS);
        box.getStyleClass().add("welcome");
        box.setMaxSize(WIDTH, HEIGHT);
        box.getChildren().addAll(actions, scroll);
        box.setOnMousePressed(event -> event.consume());
        getChildren().add(box);
        setOnMousePressed(event -> close());
        setVisible(false);
        setManaged(false);
    }

    /** Whether it is to come at the next start, too. */
    public CheckBox atStart() {
        return atStart;
    }

    /** Something that can be begun without a picture. */
    public record Beginning(String id, String text, Runnable action) {}

    /**
     * Shows what there is to begin with.
     *
     * @param first the tour, which stands out
     * @param beginnings what is below it
     * @param recent files of last time, the newest first
     * @param shipped scenes that come with the program
     */
    public void open(Beginning first, List<Beginning> beginnings, List<Offer> recent, List<Offer> shipped) {
        if (isVisible()) {
            return;
        }
        before = Optional.ofNullable(getScene()).flatMap(scene -> Optional.ofNullable(scene.getFocusOwner()));
        reader = Optional.of(Worker.named("welcome-scenes"));
        thumbnails = Optional.of(new Thumbnails(() -> Assets.none()));
        stops.clear();
        Label title = new Label("Paprsek");
        title.getStyleClass().add("welcome-title");
        Button tour = button(first);
        tour.getStyleClass().add("accent");
        actions.getChildren().setAll(title, tour);
        beginnings.forEach(one -> actions.getChildren().add(button(one)));
        Region space = new Region();
        VBox.setVgrow(space, Priority.ALWAYS);
        actions.getChildren().addAll(space, atStart);
        stops.add(atStart);
        pictures.getChildren().clear();
        group("welcome.recent", "welcome-recent", recent);
        group("welcome.shipped", "welcome-shipped", shipped);
        setVisible(true);
        setManaged(true);
        tour.requestFocus();
        Optional.ofNullable(getScene()).ifPresent(scene -> {
            scene.focusOwnerProperty().addListener(onFocus);
            scene.addEventFilter(KeyEvent.KEY_PRESSED, onKey);
        });
    }

    /** Ends what is being rendered, and gives the keyboard back to what had it. */
    public void close() {
        if (!isVisible()) {
            return;
        }
        Optional<Scene> scene = Optional.ofNullable(getScene());
        scene.ifPresent(one -> {
            one.focusOwnerProperty().removeListener(onFocus);
            one.removeEventFilter(KeyEvent.KEY_PRESSED, onKey);
        });
        boolean hasKeys = scene.map(Scene::getFocusOwner).map(this::isInside).orElse(true);
        setVisible(false);
        setManaged(false);
        if (hasKeys) {
            before.filter(node -> node.getScene() == getScene()).ifPresent(Node::requestFocus);
        }
        before = Optional.empty();
        reader.ifPresent(ExecutorService::shutdownNow);
        thumbnails.ifPresent(Thumbnails::close);
        reader = Optional.empty();
        thumbnails = Optional.empty();
        pictures.getChildren().clear();
    }

    private boolean isInside(Node node) {
        Node at = node;
        while (at != null && at != this) {
            at = at.getParent();
        }
        return at == this;
    }

    private Button button(Beginning one) {
        Button button = new Button(one.text());
        button.setId("welcome-" + one.id());
        button.setMaxWidth(Double.MAX_VALUE);
        button.setWrapText(true);
        button.setMinHeight(Region.USE_PREF_SIZE);
        button.setAlignment(Pos.CENTER_LEFT);
        button.setOnAction(event -> run(one.action()));
        stops.add(button);
        return button;
    }

    private void run(Runnable action) {
        close();
        action.run();
    }

    private void group(String title, String id, List<Offer> offers) {
        if (offers.isEmpty()) {
            return;
        }
        Label label = new Label(texts.of(title));
        label.getStyleClass().add("welcome-group");
        FlowPane tiles = new FlowPane(8, 8);
        tiles.setId(id);
        offers.forEach(offer -> tiles.getChildren().add(tile(offer)));
        pictures.getChildren().addAll(label, tiles);
    }

    private Button tile(Offer offer) {
        ImageView view = new ImageView();
        view.setFitWidth(TILE);
        view.setFitHeight(TILE * Thumbnails.HEIGHT / Thumbnails.WIDTH);
        StackPane frame = new StackPane(view);
        frame.getStyleClass().add("welcome-picture");
        frame.setMinSize(view.getFitWidth(), view.getFitHeight());
        Button tile = new Button(offer.title(), frame);
        tile.getStyleClass().add("welcome-tile");
        tile.setContentDisplay(ContentDisplay.TOP);
        tile.setTextOverrun(OverrunStyle.CENTER_ELLIPSIS);
        tile.setMaxWidth(TILE + 14);
        if (!offer.hint().isEmpty()) {
            Hint.of(tile).set(offer.hint());
        }
        tile.setOnAction(event -> run(offer.action()));
        stops.add(tile);
        Thumbnails mine = thumbnails.orElseThrow();
        reader.orElseThrow().execute(() -> {
            try {
                Offer.Subject subject = offer.reading().call();
                Platform.runLater(() -> mine.request(subject.scene(), subject.assets(),
                        () -> mine.get(subject.scene()).flatMap(Thumbnails.Picture::image).ifPresent(view::setImage)));
            } catch (Exception unreadable) {
                // What is wrong with it is told by who opens it.
                Platform.runLater(() -> frame.getStyleClass().add("welcome-unreadable"));
            }
        });
        return tile;
    }

    private void pressed(KeyEvent event) {
        if (event.getCode() == KeyCode.ESCAPE) {
            close();
        } else if (event.getCode() == KeyCode.TAB) {
            int at = getScene() == null ? -1 : stops.indexOf(getScene().getFocusOwner());
            Node next = stops.get(Math.floorMod(at + (event.isShiftDown() ? -1 : 1), stops.size()));
            next.requestFocus();
            reveal(next);
        } else {
            return;
        }
        event.consume();
    }

    /** Brings what the keyboard comes to into sight. */
    private void reveal(Node node) {
        if (box.getChildren().get(1) instanceof ScrollPane scroll && node.getStyleClass().contains("welcome-tile")) {
            double room = pictures.getHeight() - scroll.getViewportBounds().getHeight();
            double top = pictures.sceneToLocal(node.localToScene(node.getBoundsInLocal())).getMinY();
            scroll.setVvalue(room <= 0 ? 0 : Math.max(0, Math.min(1, (top - scroll.getViewportBounds().getHeight() / 3) / room)));
        }
    }
}
