package cz.paprsek.fx.view.manual;

import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.texts.Texts;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.stage.Stage;

/** The window of the manual; made when it is first needed. */
public final class ManualWindow {
    private static final double WIDTH = 1120;
    private static final double HEIGHT = 760;

    private final Supplier<Texts> texts;
    private final Supplier<Theme> theme;
    private final Consumer<Stage> placing;
    private Optional<Stage> stage = Optional.empty();

    /** @param placing puts a window that has not been shown yet where it was last */
    public ManualWindow(Supplier<Texts> texts, Supplier<Theme> theme, Consumer<Stage> placing) {
        this.texts = texts;
        this.theme = theme;
        this.placing = placing;
    }

    /** The window; empty if it has not been needed yet. */
    public Optional<Stage> stage() {
        return stage;
    }

    /** Shows the pages, from where one was last. */
    public void show() {
        Stage open = stage.orElseGet(this::fresh);
        open.show();
        open.toFront();
    }

    private Stage fresh() {
        Stage fresh = new Stage();
        ManualPane content = new ManualPane(texts.get());
        fresh.setScene(new Scene(content, WIDTH, HEIGHT));
        fresh.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE || (event.isShortcutDown() && event.getCode() == KeyCode.W)) {
                fresh.hide();
            }
        });
        placing.accept(fresh);
        stage = Optional.of(fresh);
        dress();
        return fresh;
    }

    /** Speaks the editor's language from now on. */
    public void translate() {
        stage.ifPresent(open -> {
            open.getScene().setRoot(open.getScene().getRoot() instanceof ManualPane old ? old.translated(texts.get()) : new ManualPane(texts.get()));
            dress();
        });
    }

    private void dress() {
        stage.ifPresent(open -> {
            open.setTitle(texts.get().of("manual.title"));
            theme.get().applyTo(open.getScene());
        });
    }

    public void close() {
        stage.ifPresent(Stage::close);
    }
}
