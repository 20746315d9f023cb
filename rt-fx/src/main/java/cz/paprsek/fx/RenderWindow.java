package cz.paprsek.fx;

import cz.paprsek.fx.model.file.SceneSource;
import cz.paprsek.fx.model.picture.UnfinishedPictures;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.picture.Framing;
import cz.paprsek.fx.view.render.RenderDesk;
import cz.paprsek.fx.view.render.RenderPane;
import cz.paprsek.fx.view.render.fields.Remembered;
import cz.paprsek.fx.view.shell.MessageBar;
import cz.paprsek.fx.view.texts.Shortcut;
import cz.paprsek.io.Failures;
import cz.paprsek.render.Tile;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import javafx.application.Platform;
import javafx.beans.binding.Bindings;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.value.ObservableValue;
import javafx.scene.Scene;
import javafx.stage.Stage;
import org.jspecify.annotations.Nullable;

/** The window in which pictures are rendered; made when it is first needed, and kept with its pictures when it is closed. */
final class RenderWindow {
    /** The key of the settings. */
    private static final String SAID = "render";

    private final Editor editor;
    private final Dialogs dialogs;
    private final UnfinishedPictures unfinished;
    private final RenderDesk desk;
    /** What has been offered, and answered. */
    private final Set<Path> passed = new HashSet<>();
    private final ObservableValue<Framing> framing;
    private ObservableValue<Theme> theme;
    private @Nullable Stage stage;
    private @Nullable RenderPane pane;
    private final ReadOnlyStringWrapper status = new ReadOnlyStringWrapper("");

    /** @param folder where what the program keeps for its next start is kept */
    RenderWindow(Editor editor, Dialogs dialogs, Path folder) {
        this.editor = editor;
        this.dialogs = dialogs;
        this.unfinished = new UnfinishedPictures(folder.resolve("pictures"), () -> editor.document().sourceProperty().get().map(SceneSource::file),
                fault -> Platform.runLater(() -> editor.wrong(fault)));
        // What is looked into, by which light and where, is a matter of the moment.
        this.desk = new RenderDesk(Remembered.kept(editor.settings().get(SAID), text -> editor.settings().set(SAID, text), Set.of("mode", "lights", "region")), unfinished);
        this.framing = Bindings.createObjectBinding(() -> desk.framing(editor.model().scene().settings()), editor.model().stateProperty(), desk.saidProperty());
        // A part of one scene is none of another.
        editor.model().openingsProperty().addListener((property, old, now) -> setRegion(Optional.empty()));
        editor.model().stateProperty().addListener((property, old, now) -> desk.follow(now.scene().settings()));
        this.theme = editor.followTheme();
    }

    /** Shows the window and renders the scene as was said last, else as it asks to be. */
    void render() {
        made().render();
        show();
    }

    /** Shows the window and asks how to render. */
    void ask() {
        made().ask();
        show();
    }

    /** Shows the window with the pictures there are. */
    void open() {
        show();
    }

    /** How large the next picture will be, and which part of it is rendered. */
    ObservableValue<Framing> framing() {
        return framing;
    }

    /** Has a part be rendered from now on, or whole pictures again. */
    void setRegion(Optional<Tile> part) {
        desk.setRegion(framing.getValue(), editor.model().scene().settings(), part);
    }

    /** Offers the pictures that an earlier process left unfinished, one after the other. */
    void offerLeft() {
        Background.run("paprsek-pictures", unfinished::left, left -> left.stream().filter(room -> !passed.contains(room)).findFirst().ifPresent(this::offer), this::tell);
    }

    private void offer(Path left) {
        String name = UnfinishedPictures.name(left);
        editor.ask(name.isEmpty() ? editor.texts().of("recovery.picture") : editor.texts().of("recovery.picture-of", name), List.of(
                new MessageBar.Choice("recovery-go-on", editor.texts().of("render.go-on"), () -> goOn(left)),
                new MessageBar.Choice("recovery-discard", editor.texts().of("recovery.discard"), () -> discard(left))));
    }

    private void goOn(Path left) {
        passed.add(left);
        Background.run("paprsek-pictures", () -> unfinished.take(left), resumed -> {
            made().goOn(resumed);
            show();
            offerLeft();
        }, fault -> {
            tell(fault);
            offerLeft();
        });
    }

    private void discard(Path left) {
        passed.add(left);
        try {
            unfinished.discard(left);
        } catch (IOException fault) {
            tell(fault);
        }
        offerLeft();
    }

    private void tell(Throwable fault) {
        editor.wrong(Failures.sentence(fault));
    }

    /** What has become of the last render, in words. */
    ReadOnlyStringProperty statusProperty() {
        return status.getReadOnlyProperty();
    }

    /** Speaks the editor's language from now on. */
    void translate() {
        RenderPane old = pane;
        if (old != null && stage != null) {
            RenderPane fresh = content();
            fresh.takeOver(old);
            pane = fresh;
            stage.setTitle(editor.texts().of("window.renders"));
            stage.getScene().setRoot(fresh);
            editor.theme().get().applyTo(stage.getScene());
        }
    }

    private RenderPane content() {
        theme = editor.followTheme();
        RenderPane content = new RenderPane(
                editor.model(), desk, editor.texts(), theme, dialogs.pictureChooser(editor.texts()), editor.treeChooser());
        status.bind(content.statusProperty());
        return content;
    }

    /** What the window holds, made now if it has not been. */
    private RenderPane made() {
        if (pane != null) {
            return pane;
        }
        RenderPane content = content();
        Stage made = new Stage();
        made.initOwner(editor.stage());
        made.setTitle(editor.texts().of("window.renders"));
        Scene scene = new Scene(content, 1000, 700);
        scene.getStylesheets().setAll(editor.stage().getScene().getStylesheets());
        scene.getAccelerators().put(Shortcut.of("Shortcut+W"), made::hide);
        made.setScene(scene);
        editor.theme().get().applyTo(scene);
        WindowPlace.keep(made, editor.settings(), "window.renders", () -> Sizes.opened(made, 1000, 740, Optional.empty()));
        pane = content;
        stage = made;
        return content;
    }

    /** Shows the window. All that is in it has been done before, for else its first picture would be an empty one for as long as that takes. */
    private void show() {
        RenderPane content = made();
        Stage open = Objects.requireNonNull(stage);
        if (!open.isShowing()) {
            content.applyCss();
            content.layout();
        }
        open.show();
        open.toFront();
    }

    /** Cancels what runs and closes the window. */
    void close() {
        if (pane != null) {
            pane.cancelAll();
        }
        if (stage != null) {
            stage.close();
        }
    }
}
