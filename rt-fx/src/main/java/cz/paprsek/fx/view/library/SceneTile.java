package cz.paprsek.fx.view.library;

import cz.paprsek.scene.Scene;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.image.ImageView;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import org.jspecify.annotations.Nullable;

/** One scene among others: its picture and name. There are as many tiles as can be seen. */
final class SceneTile extends VBox {
    /** Pixels, with the space around. */
    static final double WIDTH = Thumbnails.WIDTH + 22;
    static final double HEIGHT = Thumbnails.HEIGHT + 34;
    private static final PseudoClass CHOSEN = PseudoClass.getPseudoClass("chosen");

    private final Thumbnails thumbnails;
    private final ImageView picture = new ImageView();
    private final Label fault = new Label();
    private final Label name = new Label();
    private final Tooltip tooltip = new Tooltip();
    private final Runnable receiver = this::showPicture;
    private @Nullable Scene scene;

    SceneTile(Thumbnails thumbnails) {
        this.thumbnails = thumbnails;
        getStyleClass().add("scene-tile");
        picture.getStyleClass().add("thumbnail");
        picture.setFitWidth(Thumbnails.WIDTH);
        picture.setFitHeight(Thumbnails.HEIGHT);
        fault.setWrapText(true);
        fault.getStyleClass().add("refusal");
        StackPane frame = new StackPane(picture, fault);
        frame.getStyleClass().add("thumbnail-frame");
        frame.setMinSize(Thumbnails.WIDTH, Thumbnails.HEIGHT);
        frame.setMaxSize(Thumbnails.WIDTH, Thumbnails.HEIGHT);
        name.setMaxWidth(Thumbnails.WIDTH);
        tooltip.setWrapText(true);
        tooltip.setMaxWidth(360);
        setMinSize(WIDTH, HEIGHT);
        setMaxSize(WIDTH, HEIGHT);
        getChildren().addAll(frame, name);
    }

    Optional<Scene> scene() {
        return Optional.ofNullable(scene);
    }

    /** Shows a scene, or nothing. */
    void show(Optional<Scene> shown, SceneSelection selection) {
        thumbnails.cancel(receiver);
        scene = shown.orElse(null);
        setVisible(shown.isPresent());
        name.setText(shown.map(Scene::name).orElse(""));
        String words = shown.map(each -> each.name() + (each.tags().isEmpty() ? "" : "\n" + String.join("  ", each.tags()))
                + (each.description().isBlank() ? "" : "\n" + each.description().strip())).orElse("");
        tooltip.setText(words);
        if (shown.isPresent()) {
            Tooltip.install(this, tooltip);
        } else {
            Tooltip.uninstall(this, tooltip);
        }
        setAccessibleText(words);
        showPicture();
        showSelection(selection);
    }

    void showSelection(SceneSelection selection) {
        pseudoClassStateChanged(CHOSEN, scene().filter(shown -> selection.names().contains(shown.name())).isPresent());
    }

    private void showPicture() {
        Optional<Thumbnails.Picture> made = scene().flatMap(thumbnails::get);
        picture.setImage(made.flatMap(Thumbnails.Picture::image).orElse(null));
        fault.setText(made.map(Thumbnails.Picture::fault).orElse(""));
        if (made.isEmpty()) {
            scene().ifPresent(wanted -> thumbnails.request(wanted, receiver));
        }
    }
}
