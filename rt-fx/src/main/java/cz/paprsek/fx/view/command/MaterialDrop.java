package cz.paprsek.fx.view.command;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.scene.Node;
import javafx.scene.input.DragEvent;
import javafx.scene.input.Dragboard;
import javafx.scene.input.TransferMode;

/**
 * Lets a material be dropped on a body, which is highlighted before. A material is dragged as the text of a scene that has it and nothing else,
 * as the library does.
 */
public final class MaterialDrop {
    private final Edits edits;
    private final Function<DragEvent, Optional<BodyAt>> place;
    private final Consumer<Optional<BodyAt>> highlight;
    private String text = "";
    private Optional<Scene> dragged = Optional.empty();

    private MaterialDrop(Edits edits, Function<DragEvent, Optional<BodyAt>> place, Consumer<Optional<BodyAt>> highlight) {
        this.edits = edits;
        this.place = place;
        this.highlight = highlight;
    }

    /**
     * Takes materials over a node. What is dropped beside all bodies is left to whatever is around.
     *
     * @param place the body under the mouse
     * @param highlight shows a body, or none any more
     */
    public static void accept(Node node, Edits edits, Function<DragEvent, Optional<BodyAt>> place, Consumer<Optional<BodyAt>> highlight) {
        MaterialDrop drop = new MaterialDrop(edits, place, highlight);
        node.addEventHandler(DragEvent.DRAG_OVER, drop::over);
        node.addEventHandler(DragEvent.DRAG_EXITED, event -> highlight.accept(Optional.empty()));
        node.addEventHandler(DragEvent.DRAG_DROPPED, drop::dropped);
    }

    private void over(DragEvent event) {
        Optional<BodyAt> body = target(event);
        highlight.accept(body);
        if (body.isPresent()) {
            event.acceptTransferModes(TransferMode.COPY);
            event.consume();
        }
    }

    private void dropped(DragEvent event) {
        highlight.accept(Optional.empty());
        target(event).ifPresent(body -> {
            dragged.ifPresent(scene -> edits.give(body, scene));
            event.setDropCompleted(true);
            event.consume();
        });
    }

    private Optional<BodyAt> target(DragEvent event) {
        return isMaterial(event.getDragboard()) ? place.apply(event).filter(body -> !edits.model().state().isLocked(body)) : Optional.empty();
    }

    /** Read once for all the events of a drag. */
    private boolean isMaterial(Dragboard board) {
        String now = board.hasString() ? board.getString() : "";
        if (!now.equals(text)) {
            text = now;
            dragged = material(now);
        }
        return dragged.isPresent();
    }

    /** The scene that a text holds, if there is one material in it and nothing else. */
    static Optional<Scene> material(String text) {
        try {
            Scene scene = SceneFiles.parse(text);
            return Optional.of(scene).filter(some -> some.materials().size() == 1 && some.objects().isEmpty() && some.lights().isEmpty());
        } catch (SceneFileException noScene) {
            return Optional.empty();
        }
    }
}
