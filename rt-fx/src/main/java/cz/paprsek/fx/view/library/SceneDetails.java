package cz.paprsek.fx.view.library;

import cz.paprsek.fx.model.library.Library;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.TextArea;
import javafx.scene.control.TextField;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.VBox;

/** What the selected scenes are called and tagged, to be changed, and what can be done with them. */
final class SceneDetails extends VBox {
    private final Library library;
    private final SceneSelection selection;
    private final Texts texts;
    private final LibraryMessages messages;
    private final TextField name = new TextField();
    private final TextField tags = new TextField();
    private final TextArea description = new TextArea();
    private final Label facts = new Label();

    SceneDetails(Library library, SceneSelection selection, Texts texts, LibraryMessages messages, LibraryActions actions) {
        this.library = library;
        this.selection = selection;
        this.texts = texts;
        this.messages = messages;
        getStyleClass().add("scene-details");
        name.setId("library-name");
        tags.setId("library-tags");
        description.setId("library-description");
        description.setWrapText(true);
        description.setPrefRowCount(7);
        description.setMaxHeight(USE_PREF_SIZE);
        facts.setWrapText(true);
        facts.setMinHeight(USE_PREF_SIZE);
        facts.getStyleClass().add("hint");
        getChildren().addAll(new Label(texts.of("library.name")), name, new Label(texts.of("library.tags")), tags,
                new Label(texts.of("library.description")), description, facts, button("library.edit", actions::openSelected),
                button("library.insert", actions::insertSelected), button("library.duplicate", actions::duplicateSelected),
                button("library.delete", actions::deleteSelected));
        takesOver(name, this::renameTo);
        takesOver(tags, typed -> library.tag(selection.names(), typed));
        takesOver(description, typed -> library.editEach(selection.names(), scene -> scene.withDescription(typed)));
        selection.namesProperty().subscribe(names -> show());
        library.databaseProperty().addListener((property, old, now) -> show());
    }

    /** Begins to rename the scene that is selected. */
    void rename() {
        name.requestFocus();
        name.selectAll();
    }

    private void show() {
        List<Scene> scenes = selection.names().stream().flatMap(each -> library.database().find(each).stream()).toList();
        Optional<Scene> one = scenes.size() == 1 ? Optional.of(scenes.get(0)) : Optional.empty();
        setText(name, one.map(Scene::name).orElse(""));
        setText(tags, scenes.stream().map(scene -> String.join(" ", scene.tags())).distinct().count() == 1
                ? String.join(" ", scenes.get(0).tags()) : "");
        setText(description, one.map(Scene::description).orElse(""));
        facts.setText(one.map(this::facts).orElse(scenes.isEmpty() ? texts.of("library.select") : texts.of("library.selected", scenes.size())));
        name.setDisable(one.isEmpty());
        description.setDisable(one.isEmpty());
        tags.setDisable(scenes.isEmpty());
        getChildren().stream().filter(Button.class::isInstance).forEach(button -> button.setDisable(scenes.isEmpty()));
    }

    private String facts(Scene scene) {
        return texts.of("library.facts", scene.objects().size(), ScenePath.bodies(scene).filter(at -> at.depth() > 0).count(), scene.lights().size(),
                scene.materials().size(), scene.settings().width() + " × " + scene.settings().height());
    }

    private void renameTo(String typed) {
        selection.names().stream().limit(1).filter(old -> !old.equals(typed.strip())).forEach(old -> {
            library.rename(old, typed);
            selection.only(typed.strip());
        });
    }

    /** What is typed counts when Enter is pressed or the field left; Escape gives it up. What is refused is told, and typed still. */
    private void takesOver(TextInputControl field, Consumer<String> change) {
        field.focusedProperty().addListener((property, old, focused) -> {
            if (!focused) {
                apply(field, change);
            }
        });
        field.setOnKeyPressed(event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                show();
            } else if (event.getCode() == KeyCode.ENTER && field instanceof TextField) {
                apply(field, change);
            }
        });
    }

    private void apply(TextInputControl field, Consumer<String> change) {
        if (!field.isDisabled() && !field.getText().equals(field.getUserData())) {
            messages.attempt(() -> change.accept(field.getText()));
        }
    }

    private static void setText(TextInputControl field, String text) {
        field.setUserData(text);
        if (!field.getText().equals(text)) {
            field.setText(text);
        }
    }

    private Button button(String key, Runnable action) {
        Button button = LibraryActions.button(texts, key, action);
        button.setMaxWidth(Double.MAX_VALUE);
        return button;
    }
}
