package cz.paprsek.fx.view.render;

import cz.paprsek.drawing.Legend;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.view.explain.ExplainPane;
import cz.paprsek.fx.view.explain.SurfaceSelection;
import cz.paprsek.fx.view.explain.TreeChooser;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.picture.PictureChooser;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.picture.PictureStyle;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.io.Failures;
import cz.paprsek.render.RenderOptions;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javafx.beans.binding.Bindings;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.ObservableValue;
import javafx.beans.value.WeakChangeListener;
import javafx.concurrent.Task;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.SplitPane;
import javafx.scene.control.TabPane;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.input.Clipboard;
import javafx.scene.input.ClipboardContent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/** Renders the model's scene, picture by picture, each in a tab of its own, while editing goes on; saves, copies and compares them. */
public final class RenderPane extends BorderPane {
    private final EditorModel model;
    private final Texts texts;
    private final PictureChooser chooser;
    private final RenderForm form;
    private final TabPane tabs = new TabPane();
    private final ComparisonBox comparison;
    private final Label message = new Label();
    private final ReadOnlyStringWrapper status = new ReadOnlyStringWrapper("");
    private final ToggleButton explaining = new ToggleButton();
    private final ExplainPane explanation;
    private final SplitPane center;
    /** Held here, because the model, which may outlive the pane, holds it weakly. */
    private final ChangeListener<EditorState> onState = (property, old, now) -> follow(old, now);
    private Consumer<Optional<PicturePoint>> onPointed = point -> {};
    private Consumer<PicturePoint> onClicked = point -> {};
    private int count;

    public RenderPane(EditorModel model, Texts texts, ObservableValue<Theme> theme, PictureChooser chooser, TreeChooser trees) {
        this.model = model;
        this.texts = texts;
        this.chooser = chooser;
        this.form = new RenderForm(texts);
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
        form.set(model.state());
        model.stateProperty().addListener(new WeakChangeListener<>(onState));
        Button render = button("render.start", () -> render(form.options()));
        render.setDefaultButton(true);
        render.disableProperty().bind(form.valid().not());
        form.getChildren().add(render);
        tabs.setId("renders");
        tabs.setTabClosingPolicy(TabPane.TabClosingPolicy.ALL_TABS);
        message.setId("render-message");
        HBox.setHgrow(message, Priority.ALWAYS);
        message.setMaxWidth(Double.MAX_VALUE);
        Node[] tools = {
            ofPicture(keyed(button("render.save", this::save), "Shortcut+S")), ofPicture(keyed(button("render.copy", this::copy), "Shortcut+C")),
            ofPicture(button("render.fit", () -> shown().ifPresent(tab -> tab.view().fit()))),
            ofPicture(button("render.actual", () -> shown().ifPresent(tab -> tab.view().actualSize()))), comparison, explaining, message
        };
        HBox toolbar = new HBox(6, tools);
        toolbar.setAlignment(Pos.CENTER_LEFT);
        addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                shown().ifPresent(tab -> tab.task().cancel());
                event.consume();
            }
        });
        VBox top = new VBox(8, form, toolbar);
        top.getStyleClass().add("render-tools");
        setId("render-pane");
        getStylesheets().add(PictureStyle.sheet());
        setTop(top);
        setCenter(center);
    }

    /** Fills the form with what the scene asks for, and renders. */
    public void renderAsTheSceneAsks() {
        form.set(model.state());
        render(form.options());
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
        other.tabs.getTabs().forEach(tab -> add(new RenderTab(tab.getText(), ((RenderTab) tab).task(), texts)));
        count = other.count;
    }

    /** Cancels all that runs. */
    public void cancelAll() {
        tabs.getTabs().forEach(tab -> ((RenderTab) tab).task().cancel());
    }

    private void follow(EditorState old, EditorState now) {
        if (old.eye() != now.eye() || !old.scene().cameras().equals(now.scene().cameras())) {
            form.follow(now);
        }
    }

    private void render(RenderOptions options) {
        message.setText("");
        RenderTask task;
        try {
            task = new RenderTask(form.chosen(model.scene()), model.assets(), options);
        } catch (IllegalArgumentException | ArithmeticException | OutOfMemoryError tooLarge) {
            message.setText(texts.of("render.too-large", options.settings().width(), options.settings().height()));
            return;
        }
        String name = model.scene().name().isBlank() ? "" : model.scene().name() + " · ";
        add(new RenderTab(++count + ": " + name + options.settings().width() + " × " + options.settings().height() + form.remark(), task, texts));
        start(task, "paprsek-render");
    }

    private void add(RenderTab tab) {
        tab.pointedProperty().addListener((property, old, now) -> pointed(now));
        tab.setOnClicked(this::clicked);
        tabs.getTabs().add(tab);
        tabs.getSelectionModel().select(tab);
        status.bind(tab.statusProperty());
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

    private void save() {
        Optional<RenderTab> tab = shown();
        Optional<Image> image = tab.flatMap(shown -> shown.task().image());
        if (image.isEmpty()) {
            message.setText(texts.of("render.nothing"));
            return;
        }
        String name = tab.map(shown -> shown.task().subject().whole().name()).filter(Predicate.not(String::isBlank)).orElse("picture");
        chooser.choose(getScene().getWindow(), name.replaceAll("[\\\\/:*?\"<>|]", "-") + ".png").ifPresent(file -> write(finished(tab.get(), image.get()), file, tab.get().task()));
    }

    /** The picture as it is saved: a heat map with its scale. */
    private static Image finished(RenderTab tab, Image image) {
        return tab.task().options().mode().scale().map(scale -> Legend.below(image, scale)).orElse(image);
    }

    private void write(Image image, Path file, RenderTask task) {
        Task<Boolean> writing = new Task<>() {
            @Override
            protected Boolean call() throws Exception {
                ImageFiles.write(image, file, task.saved(ImageFormat.ofFile(file.toString()).orElse(ImageFormat.PNG)));
                return true;
            }
        };
        message.setText(texts.of("render.saving", file.getFileName()));
        writing.setOnSucceeded(event -> message.setText(texts.of("render.saved", file.getFileName())));
        writing.setOnFailed(event -> message.setText(texts.of("render.not-saved", file.getFileName(), Failures.sentence(writing.getException()))));
        start(writing, "paprsek-save-picture");
    }

    private void copy() {
        shown().ifPresent(tab -> {
            ClipboardContent content = new ClipboardContent();
            content.putImage(tab.task().buffer().image());
            Clipboard.getSystemClipboard().setContent(content);
            message.setText(texts.of("render.copied"));
        });
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
        KeyCombination combination = KeyCombination.valueOf(keys);
        button.setTooltip(new Tooltip(combination.getDisplayText()));
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

    private static void start(Task<?> task, String name) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        thread.start();
    }
}
