package cz.paprsek.fx.view.find;

import cz.paprsek.fx.view.look.MaterialBalls;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;

/** What keys there are, what the mouse does, and what the symbols of explanations mean: above everything, until Escape or a click beside it. */
public final class HelpPane extends StackPane {
    /** What is done in views by mouse and keys, which no menu says: each has the keys "hand.…" and "hand.….does". */
    private static final List<String> HANDS = List.of("hand.select", "hand.more", "hand.move", "hand.free", "hand.straight", "hand.add", "hand.handles", "hand.zoom", "hand.pan",
            "hand.orbit", "hand.camera-pan", "hand.dolly", "hand.inner", "hand.part", "hand.cut", "hand.regions", "hand.title", "hand.escape");
    /** Symbols, each with the keys "glossary.…" and "glossary.….means". */
    private static final List<String> SYMBOLS = List.of("glossary.kd", "glossary.ks", "glossary.n", "glossary.kr", "glossary.kt", "glossary.eta", "glossary.f", "glossary.vectors",
            "glossary.theta", "glossary.linear", "glossary.ambient", "glossary.whitted", "glossary.paths", "glossary.ggx");
    private static final Material RED = Material.DEFAULT.withPattern(new Pattern.Plain(new Rgb(214, 80, 66)));
    private static final Material CLEAR = Material.DEFAULT.withDiffusion(0.05);
    /** Of what a symbol stands for, as a ball of it shows it. */
    private static final Map<String, Material> BALLS = Map.of(
            "glossary.kd", RED,
            "glossary.ks", RED.withHighlight(0.9, 12),
            "glossary.n", RED.withHighlight(0.9, 200),
            "glossary.kr", CLEAR.withReflection(0.85),
            "glossary.kt", CLEAR.withTransparency(0.9, 1),
            "glossary.eta", CLEAR.withTransparency(0.9, 1.5),
            "glossary.f", CLEAR.withDiffusion(0).withReflection(1).withTransparency(1, 1.5).withFresnel(Material.Fresnel.TRUE),
            "glossary.ggx", CLEAR.withReflection(0.85).withRoughness(0.4));
    private static final double WIDTH = 660;
    private static final double HEIGHT = 600;
    private static final double FIRST = 190;

    private final Texts texts;
    private final Supplier<List<Findable>> commands;
    private final TabPane tabs = new TabPane();
    private Optional<Node> before = Optional.empty();

    /** What it shows first. */
    public enum Page { KEYS, HANDS, GLOSSARY }

    /** @param commands all that stands in menus */
    public HelpPane(Texts texts, Supplier<List<Findable>> commands) {
        this.texts = texts;
        this.commands = commands;
        setId("help");
        getStyleClass().add("help-room");
        getStylesheets().add(String.valueOf(HelpPane.class.getResource("find.css")));
        tabs.getStyleClass().add("help");
        tabs.setMaxSize(WIDTH, HEIGHT);
        tabs.setOnMousePressed(event -> event.consume());
        getChildren().add(tabs);
        addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            boolean isEnd = event.getCode() == KeyCode.ESCAPE || event.getCode() == KeyCode.F1;
            if (isEnd) {
                close();
            }
            // Tab would lead to what is covered, where Escape is not heard.
            if (isEnd || event.getCode() == KeyCode.TAB) {
                event.consume();
            }
        });
        setOnMousePressed(event -> close());
        setVisible(false);
        setManaged(false);
    }

    public void open(Page page) {
        before = isVisible() ? before : Optional.ofNullable(getScene()).flatMap(scene -> Optional.ofNullable(scene.getFocusOwner()));
        GridPane keys = table();
        commands.get().stream().filter(one -> !one.keys().isEmpty()).forEach(one -> row(keys, one.keys(), one.name()));
        GridPane hands = table();
        HANDS.forEach(hand -> row(hands, texts.of(hand), texts.of(hand + ".does")));
        GridPane symbols = table();
        symbols.getColumnConstraints().add(1, new ColumnConstraints(MaterialBalls.SIZE));
        SYMBOLS.forEach(symbol -> symbols.addRow(symbols.getRowCount(), label(texts.of(symbol), "help-what"), picture(symbol), label(texts.of(symbol + ".means"), "help-means")));
        MaterialBalls.paint(BALLS, (symbol, image) -> symbols.getChildren().stream().filter(node -> symbol.equals(node.getId())).forEach(node -> ((ImageView) node).setImage(image)));
        tabs.getTabs().setAll(tab("help-keys", texts.of("help.keys"), keys), tab("help-hands", texts.of("help.hands"), hands),
                tab("help-glossary", texts.of("help.glossary"), symbols));
        tabs.getSelectionModel().select(page == Page.KEYS ? 0 : page == Page.HANDS ? 1 : 2);
        setVisible(true);
        setManaged(true);
        tabs.requestFocus();
    }

    /** Gives the keyboard back to what had it. */
    private void close() {
        before.filter(node -> node.getScene() == getScene()).ifPresent(Node::requestFocus);
        before = Optional.empty();
        setVisible(false);
        setManaged(false);
        tabs.getTabs().clear();
    }

    private static Tab tab(String id, String title, Node table) {
        ScrollPane scroll = new ScrollPane(table);
        scroll.setFitToWidth(true);
        scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
        Tab tab = new Tab(title, scroll);
        tab.setId(id);
        tab.setClosable(false);
        return tab;
    }

    private static GridPane table() {
        GridPane table = new GridPane();
        table.getStyleClass().add("help-table");
        ColumnConstraints second = new ColumnConstraints(0, FIRST, Double.MAX_VALUE);
        second.setHgrow(Priority.ALWAYS);
        table.getColumnConstraints().addAll(new ColumnConstraints(FIRST), second);
        return table;
    }

    private static void row(GridPane table, String what, String means) {
        table.addRow(table.getRowCount(), label(what, "help-what"), label(means, "help-means"));
    }

    /** Comes when it is rendered; of some symbols there is none. */
    private static ImageView picture(String symbol) {
        ImageView picture = new ImageView();
        picture.setId(symbol);
        if (BALLS.containsKey(symbol)) {
            picture.setFitWidth(MaterialBalls.SIZE);
            picture.setFitHeight(MaterialBalls.SIZE);
        }
        return picture;
    }

    private static Label label(String text, String style) {
        Label label = new Label(text);
        label.getStyleClass().add(style);
        label.setWrapText(true);
        label.setMinHeight(Region.USE_PREF_SIZE);
        return label;
    }
}
