package cz.paprsek.fx.view.render;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.picture.UnfinishedPicture;
import cz.paprsek.fx.model.picture.UnfinishedPictures.Resumed;
import cz.paprsek.fx.view.explain.ExplainPane;
import cz.paprsek.fx.view.explain.SurfaceSelection;
import cz.paprsek.fx.view.explain.TreeChooser;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.picture.Framing;
import cz.paprsek.fx.view.picture.PictureChooser;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.picture.PictureStyle;
import cz.paprsek.fx.view.render.fields.RegionFields;
import cz.paprsek.fx.view.texts.Shortcut;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Tile;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javafx.beans.binding.Bindings;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.ObservableValue;
import javafx.beans.value.WeakChangeListener;
import javafx.collections.ListChangeListener;
import javafx.collections.WeakListChangeListener;
import javafx.geometry.Pos;
import javafx.geometry.VPos;
import javafx.scene.control.Button;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Label;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SplitPane;
import javafx.scene.control.TabPane;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;

/** Renders the model's scene, picture by picture, each in a tab of its own, while editing goes on; saves, copies and compares them. */
public final class RenderPane extends StackPane {
    private final EditorModel model;
    private final Texts texts;
    private final RenderDesk desk;
    private final RenderForm form;
    private final RenderDialog dialog;
    private final BorderPane body = new BorderPane();
    private final QueuePane queue;
    private final ToggleButton queueing = new ToggleButton();
    private final ToggleButton selecting = new ToggleButton();
    private final Button clear;
    private final ContextMenu menu;
    private final TabPane tabs = new TabPane();
    private final ComparisonBox comparison;
    private final Label message = new Label();
    private final ReadOnlyStringWrapper status = new ReadOnlyStringWrapper("");
    private final ToggleButton explaining = new ToggleButton();
    private final ExplainPane explanation;
    private final SplitPane center;
    /** Held here, because the model, which may outlive the pane, holds it weakly. */
    private final ChangeListener<EditorState> onState = (property, old, now) -> follow(old, now);
    private final ChangeListener<Map<String, String>> onSaid = (property, old, now) -> followSaid(old, now);
    private Consumer<Optional<PicturePoint>> onPointed = point -> {};
    private Consumer<PicturePoint> onClicked = point -> {};
    /** Held here likewise: the desk outlives the pane. */
    private final ListChangeListener<RenderTask> queued = change -> follow();
    private final WeakListChangeListener<RenderTask> onQueue = new WeakListChangeListener<>(queued);
    private int count;

    /** @param desk what outlives this pane */
    public RenderPane(EditorModel model, RenderDesk desk, Texts texts, ObservableValue<Theme> theme, PictureChooser chooser, TreeChooser trees) {
        this.model = model;
        this.desk = desk;
        this.texts = texts;
        this.form = new RenderForm(texts);
        this.dialog = new RenderDialog(form, texts, body, this::takeKeys, this::answered, () -> form.set(model.state(), Map.of()));
        this.queue = new QueuePane(desk, texts, this::show);
        this.comparison = new ComparisonBox(tabs, texts);
        this.explanation = new ExplainPane(texts, theme, trees);
        explanation.addDrawings(theme);
        explanation.setOnChosen(new SurfaceSelection(model)::select);
        this.center = new SplitPane(tabs);
        center.setDividerPositions(0.55);
        explaining.setText(texts.of("explain.mode"));
        explaining.setId("explain-mode");
        explaining.setMinWidth(Region.USE_PREF_SIZE);
        explaining.setOnAction(event -> explain(explaining.isSelected()));
        toggle(queueing, "render.queue").selectedProperty().bindBidirectional(queue.visibleProperty());
        queueing.setSelected(desk.queue().size() > 1);
        queue.managedProperty().bind(queue.visibleProperty());
        desk.queue().addListener(onQueue);
        form.set(model.state(), desk.said().answers());
        model.stateProperty().addListener(new WeakChangeListener<>(onState));
        desk.saidProperty().addListener(new WeakChangeListener<>(onSaid));
        tabs.setId("renders");
        tabs.setTabClosingPolicy(TabPane.TabClosingPolicy.ALL_TABS);
        message.setId("render-message");
        clear = button("render.region.clear", this::clearRegion);
        clear.managedProperty().bind(clear.visibleProperty());
        Hint.of(toggle(selecting, "render.region.drag")).set(texts.of("render.region.drag.hint"));
        selecting.disableProperty().bind(Bindings.isEmpty(tabs.getTabs()));
        PictureSaving saving = new PictureSaving(texts, chooser, message::setText);
        List<Button> buttons = List.of(
                keyed(button("render.again", this::render), "Shortcut+R"), keyed(button("render.ask", this::ask), "Shortcut+Alt+R"),
                ofPicture(keyed(button("render.save", () -> shown().ifPresent(tab -> saving.save(getScene().getWindow(), tab.task()))), "Shortcut+S")),
                ofPicture(keyed(button("render.copy", () -> shown().ifPresent(tab -> saving.copy(tab.task()))), "Shortcut+C")),
                ofPicture(button("render.fit", () -> shown().ifPresent(tab -> tab.view().fit()))),
                ofPicture(button("render.actual", () -> shown().ifPresent(tab -> tab.view().actualSize()))));
        menu = menu(Stream.concat(buttons.stream(), Stream.of(clear)).toList());
        FlowPane toolbar = new FlowPane(6, 6);
        toolbar.getChildren().addAll(buttons);
        toolbar.getChildren().addAll(selecting, clear, queueing, explaining, comparison);
        toolbar.setRowValignment(VPos.CENTER);
        toolbar.getStyleClass().add("render-tools");
        addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                escape();
                event.consume();
            }
        });
        setId("render-pane");
        getStylesheets().add(PictureStyle.sheet());
        body.setTop(toolbar);
        body.setCenter(center);
        body.setLeft(queue);
        // Over the line of the state, which would else move the picture whenever something is told.
        setAlignment(message, Pos.BOTTOM_RIGHT);
        message.setMouseTransparent(true);
        message.visibleProperty().bind(message.textProperty().isNotEmpty());
        getChildren().addAll(body, message, dialog);
        showRegion();
    }

    private ToggleButton toggle(ToggleButton button, String key) {
        button.setText(texts.of(key));
        button.setId(key.replace('.', '-') + "-toggle");
        button.setMinWidth(Region.USE_PREF_SIZE);
        return button;
    }

    /** Renders as was said last, and else as the scene asks; asks if that cannot be. What is asked just now waits for its answer. */
    public void render() {
        if (dialog.isVisible()) {
            return;
        }
        form.set(model.state(), desk.said().answers());
        if (form.valid().get()) {
            render(form, model.scene(), model.assets(), desk.unfinished().begin(model.scene(), form.words()));
        } else {
            dialog.open();
        }
    }

    /** Asks how to render. */
    public void ask() {
        if (!dialog.isVisible()) {
            form.set(model.state(), desk.said().answers());
            dialog.open();
        }
    }

    /** Has the picture that is shown take the keyboard. */
    private void takeKeys() {
        shown().ifPresent(tab -> tab.view().requestFocus());
    }

    private void answered() {
        desk.said().set(form.said());
        render(form, model.scene(), model.assets(), desk.unfinished().begin(model.scene(), form.words()));
    }

    /** Is told where in a picture the mouse is, and when it leaves. */
    public void setOnPointed(Consumer<Optional<PicturePoint>> listener) {
        onPointed = listener;
    }

    /** Is told of clicks on a picture. */
    public void setOnClicked(Consumer<PicturePoint> listener) {
        onClicked = listener;
    }

    /** How far the newest render is, or how it ended, in words; empty before the first one. */
    public ReadOnlyStringProperty statusProperty() {
        return status.getReadOnlyProperty();
    }

    /** Takes in the pictures of another pane, such as one in another language, also those that are still being rendered. */
    public void takeOver(RenderPane other) {
        other.tabs.getTabs().stream().map(RenderTab.class::cast).toList().forEach(tab -> {
            tab.release();
            add(new RenderTab(tab.task(), desk, texts));
        });
        count = other.count;
        follow();
    }

    /** Cancels all that runs. */
    public void cancelAll() {
        desk.cancelAll();
    }

    /** What is drawn elsewhere while it is asked here is the answer. */
    private void followSaid(Map<String, String> old, Map<String, String> now) {
        Optional<String> region = Optional.ofNullable(now.get(RenderDesk.REGION));
        if (dialog.isVisible() && !region.equals(Optional.ofNullable(old.get(RenderDesk.REGION)))) {
            form.sayRegion(region.orElse(""));
        }
        showRegion();
    }

    private void follow(EditorState old, EditorState now) {
        if (old.eye() != now.eye()) {
            // Looking through another camera was the last word about it.
            desk.said().forget("camera");
        }
        if (old.eye() != now.eye() || !old.scene().cameras().equals(now.scene().cameras())) {
            form.follow(now);
        }
    }

    /** Goes on with a picture that an earlier process left, whatever scene is open. */
    public void goOn(Resumed left) {
        // Another form than the one that may be open.
        RenderForm its = new RenderForm(texts);
        its.set(EditorState.of(left.scene()), left.answers());
        if (its.valid().get()) {
            render(its, left.scene(), left.assets(), left.kept());
        } else {
            left.kept().leave();
            message.setText(texts.of("render.left-unfit"));
        }
    }

    private void render(RenderForm form, Scene scene, Assets assets, UnfinishedPicture kept) {
        RenderOptions options = form.options();
        message.setText("");
        RenderTask task;
        try {
            String name = scene.name().isBlank() ? "" : scene.name() + " · ";
            String title = count + 1 + ": " + name + options.settings().width() + " × " + options.settings().height() + form.remark();
            task = new RenderTask(title, form.chosen(scene), assets, options, kept);
        } catch (IllegalArgumentException | ArithmeticException | OutOfMemoryError tooLarge) {
            message.setText(texts.of("render.too-large", options.settings().width(), options.settings().height()));
            return;
        }
        count++;
        add(new RenderTab(task, desk, texts));
        desk.add(task);
    }

    /** Shows the list as soon as something waits, and the state of what is under way. */
    private void follow() {
        if (desk.queue().size() > 1) {
            queueing.setSelected(true);
        }
        if (!desk.queue().isEmpty()) {
            tab(desk.queue().get(0)).ifPresent(tab -> status.bind(tab.statusProperty()));
        }
    }

    private Optional<RenderTab> tab(RenderTask task) {
        return tabs.getTabs().stream().map(RenderTab.class::cast).filter(tab -> tab.task() == task).findFirst();
    }

    private void show(RenderTask task) {
        tab(task).ifPresent(tabs.getSelectionModel()::select);
    }

    /** Gives up a rectangle that is being drawn, or cancels what is shown if it runs or waits, or renders whole pictures again. */
    private void escape() {
        if (shown().filter(tab -> tab.view().giveUpRegion()).isPresent()) {
            return;
        }
        shown().filter(tab -> !tab.task().isOver()).ifPresentOrElse(tab -> tab.task().cancel(), this::clearRegion);
    }

    /** From now on a part is rendered, of pictures as large as the one that it was drawn in. */
    private void setRegion(RenderTab tab, Tile region) {
        RenderSettings its = tab.task().options().settings();
        desk.setRegion(new Framing(its.width(), its.height(), Optional.empty()), model.scene().settings(), Optional.of(region));
    }

    private void clearRegion() {
        desk.said().forget(RenderDesk.REGION);
    }

    private static String size(RenderTab tab) {
        return tab.task().options().settings().width() + "x" + tab.task().options().settings().height();
    }

    /** Shows the part that is to be rendered in all pictures as large. */
    private void showRegion() {
        String word = desk.said().answers().getOrDefault(RenderDesk.REGION, "");
        clear.setVisible(!word.isEmpty());
        tabs.getTabs().stream().map(RenderTab.class::cast).forEach(tab -> tab.view().showRegion(RegionFields.parse(word, size(tab))));
    }

    private void add(RenderTab tab) {
        tab.pointedProperty().addListener((property, old, now) -> pointed(now));
        tab.setOnClicked(this::clicked);
        tab.view().selectingProperty().bind(selecting.selectedProperty());
        tab.view().showRegion(RegionFields.parse(desk.said().answers().getOrDefault(RenderDesk.REGION, ""), size(tab)));
        tab.view().setOnRegion(region -> setRegion(tab, region));
        tab.setOnClosed(event -> tab.close());
        tab.view().setOnContextMenuRequested(event -> menu.show(tab.view(), event.getScreenX(), event.getScreenY()));
        tabs.getTabs().add(tab);
        if (desk.queue().isEmpty()) {
            // What has to wait leaves the one under way in sight.
            tabs.getSelectionModel().select(tab);
            status.bind(tab.statusProperty());
            takeKeys();
        }
    }

    private void explain(boolean on) {
        if (on) {
            center.getItems().setAll(tabs, explanation);
        } else {
            center.getItems().setAll(tabs);
            explanation.clear();
        }
    }

    private void pointed(Optional<PicturePoint> point) {
        onPointed.accept(point);
        if (explaining.isSelected()) {
            explanation.hover(point);
        }
    }

    /** In explain mode a click stays at a pixel, for the arrow keys to go on from there, and the next click follows the mouse again. */
    private void clicked(PicturePoint point) {
        onClicked.accept(point);
        if (explaining.isSelected()) {
            explanation.click(point);
            explanation.takeKeys();
        }
    }

    /** What can be done with the picture, as a menu: the same as by buttons. */
    private static ContextMenu menu(List<Button> buttons) {
        ContextMenu menu = new ContextMenu();
        for (Button button : buttons) {
            MenuItem item = new MenuItem(button.getText());
            item.setId(button.getId() + "-item");
            item.setMnemonicParsing(false);
            item.disableProperty().bind(button.disabledProperty());
            item.visibleProperty().bind(button.visibleProperty());
            item.setOnAction(event -> button.fire());
            menu.getItems().add(item);
        }
        return menu;
    }

    private Optional<RenderTab> shown() {
        return Optional.ofNullable((RenderTab) tabs.getSelectionModel().getSelectedItem());
    }

    private Button button(String key, Runnable action) {
        Button button = new Button(texts.of(key));
        button.setId(key.replace('.', '-'));
        button.setMinWidth(Region.USE_PREF_SIZE);
        button.setOnAction(event -> action.run());
        return button;
    }

    /** Has keys do what a button does, except in a text field, which has a use of its own for Ctrl+C. */
    private Button keyed(Button button, String keys) {
        KeyCombination combination = Shortcut.of(keys);
        Hint.of(button).set(combination.getDisplayText());
        addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (combination.match(event)) {
                button.fire();
                event.consume();
            }
        });
        return button;
    }

    /** Makes a button work only if there is a picture. */
    private Button ofPicture(Button button) {
        button.disableProperty().bind(Bindings.isEmpty(tabs.getTabs()));
        return button;
    }
}
