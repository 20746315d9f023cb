package cz.paprsek.fx.view.render;

import cz.paprsek.drawing.Legend;
import cz.paprsek.fx.view.picture.PictureChooser;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.Layers;
import cz.paprsek.io.Failures;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.concurrent.Task;
import javafx.scene.input.Clipboard;
import javafx.scene.input.ClipboardContent;
import javafx.stage.Window;

/** Saves and copies pictures, as far as they have got. */
final class PictureSaving {
    private final Texts texts;
    private final PictureChooser chooser;
    private final Consumer<String> say;

    /** @param say tells what becomes of it, in a sentence, on JavaFX's thread */
    PictureSaving(Texts texts, PictureChooser chooser, Consumer<String> say) {
        this.texts = texts;
        this.chooser = chooser;
        this.say = say;
    }

    /** Asks where, and saves. */
    void save(Window owner, RenderTask task) {
        Optional<Image> image = task.image();
        if (image.isEmpty()) {
            say.accept(texts.of("render.nothing"));
            return;
        }
        String scene = task.subject().whole().name();
        String name = scene.isBlank() ? "picture" : scene.replaceAll("[\\\\/:*?\"<>|]", "-");
        chooser.choose(owner, name + ".png").ifPresent(file -> write(finished(task, image.get()), file, task));
    }

    /** The picture as it is saved: a heat map with its scale. */
    private static Image finished(RenderTask task, Image image) {
        return task.options().mode().scale().map(scale -> Legend.below(image, scale)).orElse(image);
    }

    private void write(Image image, Path file, RenderTask task) {
        Task<Boolean> writing = new Task<>() {
            @Override
            protected Boolean call() throws Exception {
                ImageFormat format = ImageFormat.ofFile(file.toString()).orElse(ImageFormat.PNG);
                Optional<Layers> lights = task.mixer().filter(mixer -> format == ImageFormat.EXR).map(Mixer::layers)
                        .filter(layers -> !layers.names().isEmpty() && layers.width() == image.width() && layers.height() == image.height());
                if (lights.isPresent()) {
                    ImageFiles.write(image, lights.get(), file, task.saved(format));
                } else {
                    ImageFiles.write(image, file, task.saved(format));
                }
                return true;
            }
        };
        say.accept(texts.of("render.saving", file.getFileName()));
        writing.setOnSucceeded(event -> say.accept(texts.of("render.saved", file.getFileName())));
        writing.setOnFailed(event -> say.accept(texts.of("render.not-saved", file.getFileName(), texts.sentence(Failures.sentence(writing.getException())))));
        RenderDesk.start(writing, "paprsek-save-picture");
    }

    void copy(RenderTask task) {
        ClipboardContent content = new ClipboardContent();
        content.putImage(task.buffer().image());
        Clipboard.getSystemClipboard().setContent(content);
        say.accept(texts.of("render.copied"));
    }
}
