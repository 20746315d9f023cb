package cz.paprsek.fx.view.library;

import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.util.Optional;
import javafx.scene.Node;
import javafx.scene.image.Image;
import javafx.scene.input.ClipboardContent;
import javafx.scene.input.Dragboard;
import javafx.scene.input.TransferMode;

/** Begins to drag something out of the library: as the text of a scene file, which any window can take. */
final class LibraryDrag {
    private LibraryDrag() {}

    static void start(Node from, Scene scene, Optional<Image> picture) {
        ClipboardContent content = new ClipboardContent();
        content.putString(SceneFiles.format(scene));
        Dragboard board = from.startDragAndDrop(TransferMode.COPY);
        board.setContent(content);
        picture.ifPresent(board::setDragView);
    }
}
