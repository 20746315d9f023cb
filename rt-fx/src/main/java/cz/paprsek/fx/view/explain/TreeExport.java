package cz.paprsek.fx.view.explain;

import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.io.Failures;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.layout.Region;

/** Saves the tree of the pixel that is explained. */
final class TreeExport extends MenuButton {
    private final ExplainPane pane;
    private final Texts texts;
    private final TreeChooser chooser;
    private final Consumer<String> message;

    TreeExport(ExplainPane pane, Texts texts, TreeChooser chooser, Consumer<String> message) {
        super(texts.of("explain.export"));
        this.pane = pane;
        this.texts = texts;
        this.chooser = chooser;
        this.message = message;
        setId("explain-export");
        setMinWidth(Region.USE_PREF_SIZE);
        setDisable(true);
        pane.drawnProperty().addListener((property, old, now) -> setDisable(now.isEmpty()));
        for (TreeFiles kind : TreeFiles.values()) {
            MenuItem item = new MenuItem(texts.of("explain.save" + kind.extension()) + "…");
            item.setId("explain-save-" + kind.extension().substring(1));
            item.setOnAction(event -> pane.explained().ifPresent(point -> save(kind, point)));
            getItems().add(item);
        }
    }

    private void save(TreeFiles kind, PicturePoint point) {
        String name = point.scene().scene().name().replaceAll("[\\\\/:*?\"<>|]", "-");
        String suggestion = (name.isBlank() ? "" : name + "-") + point.column() + "-" + point.row() + kind.extension();
        chooser.choose(getScene().getWindow(), suggestion).ifPresent(file -> pane.told().ifPresent(pixel -> write(kind, point, pixel, file)));
    }

    private void write(TreeFiles kind, PicturePoint point, Explained pixel, Path file) {
        try {
            kind.write(point, pixel, pane.ray(), texts.words(), file);
            message.accept(texts.of("render.saved", file.getFileName()));
        } catch (IOException e) {
            message.accept(texts.of("render.not-saved", file.getFileName(), texts.sentence(Failures.sentence(e))));
        } catch (IllegalArgumentException notOfPaths) {
            message.accept(texts.of("render.not-saved", file.getFileName(), texts.sentence(String.valueOf(notOfPaths.getMessage()))));
        }
    }
}
