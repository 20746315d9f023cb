package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.javafx.scene.input.DragboardHelper;
import com.sun.javafx.tk.TKClipboard;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.io.File;
import java.io.IOException;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import javafx.event.Event;
import javafx.event.EventType;
import javafx.scene.Node;
import javafx.scene.input.DataFormat;
import javafx.scene.input.DragEvent;
import javafx.scene.input.Dragboard;
import javafx.scene.input.PickResult;
import javafx.scene.input.TransferMode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files come out of the file manager: on the views meshes are added, and scenes are opened. */
class DroppedFilesTest {
    private static final String CORNER = "v 0 0 0\nv 3 0 0\nv 0 4 0\nv 0 0 5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

    @TempDir
    Path folder;

    private Path corner = Path.of("");
    private EditorGui editor;

    @BeforeEach
    void start() throws Exception {
        corner = Files.writeString(folder.resolve("corner.obj"), CORNER);
        editor = new EditorGui(folder.resolve("settings"), Scene.EMPTY);
        Path file = folder.resolve("scene.xml");
        SceneFiles.write(Scene.EMPTY.plus(SceneObject.of(new Sphere(1))), file);
        editor.gui.act(() -> editor.editor.files().open(file));
        editor.gui.until("the scene is there", () -> editor.gui.stage().getTitle().startsWith("scene.xml"));
    }

    @AfterEach
    void close() {
        editor.close();
    }

    private static DragEvent event(EventType<DragEvent> type, Dragboard files, Node on) {
        return new DragEvent(type, files, 5, 5, 5, 5, TransferMode.COPY, null, null, new PickResult(on, 5, 5));
    }

    /** What a file manager holds out. */
    private static TKClipboard board(List<File> files) {
        return (TKClipboard) Proxy.newProxyInstance(TKClipboard.class.getClassLoader(), new Class<?>[] {TKClipboard.class}, (self, method, arguments) -> switch (method.getName()) {
            case "getTransferModes" -> Set.of(TransferMode.COPY);
            case "getContentTypes" -> Set.of(DataFormat.FILES);
            case "setSecurityContext" -> null;
            case "hasContent" -> DataFormat.FILES.equals(arguments[0]);
            case "getContent" -> DataFormat.FILES.equals(arguments[0]) ? files : null;
            default -> throw new UnsupportedOperationException(method.getName());
        });
    }

    /** Drops files on a node, which must want them. */
    private void drop(String on, Path... files) {
        Node node = editor.gui.node(on);
        boolean isTaken = Gui.on(() -> {
            Dragboard dragged = DragboardHelper.createDragboard(board(Stream.of(files).map(Path::toFile).toList()));
            DragEvent over = event(DragEvent.DRAG_OVER, dragged, node);
            Event.fireEvent(node, over);
            DragEvent dropped = event(DragEvent.DRAG_DROPPED, dragged, node);
            Event.fireEvent(node, dropped);
            return over.isAccepted() && dropped.isDropCompleted();
        });
        assertThat(isTaken).isTrue();
    }

    private List<String> meshes() {
        return editor.model().scene().objects().stream().map(SceneObject::shape).filter(Mesh.class::isInstance).map(shape -> ((Mesh) shape).file()).toList();
    }

    @Test
    void onAViewAMeshIsAdded() {
        drop("#projection-front", corner);
        editor.gui.until("it is there", () -> meshes().equals(List.of("corner.obj")));
        assertThat(editor.model().scene().objects()).as("beside what was there").hasSize(2);
    }

    @Test
    void ofSeveralAllAreAddedAndWhatIsWrongWithOneIsTold() throws IOException {
        Path bad = Files.writeString(folder.resolve("bad.stl"), "solid x\nfacet\nvertex 1 2\n");
        Path other = Files.writeString(folder.resolve("other.obj"), CORNER);
        Path text = Files.writeString(folder.resolve("notes.txt"), "no mesh");
        drop("#projection-front", corner, bad, other, text);
        editor.gui.until("both are there", () -> meshes().equals(List.of("corner.obj", "other.obj")));
        assertThat(editor.status()).contains("notes.txt").contains("line 3: z of a corner is missing");
        assertThat(editor.dialogs.faults).isEmpty();
    }

    @Test
    void aSceneBeforeTheMeshesDoesNotKeepThemAway() throws Exception {
        Path scene = folder.resolve("second.xml");
        SceneFiles.write(Scene.EMPTY.plus(SceneObject.of(new Sphere(2))), scene);
        drop("#projection-front", scene, corner);
        editor.gui.until("the mesh is there", () -> meshes().equals(List.of("corner.obj")));
        assertThat(editor.status()).contains("second.xml");
    }

    @Test
    void aBadOneChangesNothing() throws IOException {
        Path bad = Files.writeString(folder.resolve("bad.ply"), "ply\nformat ascii 1.0\nelement vertex 4000000000\n");
        drop("#projection-front", bad);
        editor.gui.until("told", () -> editor.status().contains("the file ends within its head"));
        assertThat(editor.model().scene().objects()).hasSize(1);
    }

    @Test
    void aSceneIsOpenedWhereverItIsDropped() throws Exception {
        Path scene = folder.resolve("second.xml");
        SceneFiles.write(Scene.EMPTY.plus(SceneObject.of(new Sphere(2))), scene);
        drop("#projection-front", scene);
        editor.gui.until("it is open", () -> editor.gui.stage().getTitle().startsWith("second.xml"));
    }

    @Test
    void onTheMenuBarAModelIsOpened() {
        drop("#menu-bar", corner);
        editor.gui.until("it is open", () -> editor.model().scene().objects().stream().anyMatch(object -> object.shape() instanceof Mesh));
        assertThat(editor.status()).contains("corner.obj");
    }

    @Test
    void whatIsNoModelIsSaidToBeNoneAndNotAskedFor() throws IOException {
        Path text = Files.writeString(folder.resolve("notes.txt"), "no mesh");
        Path picture = Files.write(folder.resolve("picture.png"), new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'});
        drop("#menu-bar", text);
        editor.gui.until("told", () -> editor.status().startsWith("notes.txt is neither a scene nor a model"));
        drop("#projection-front", picture);
        editor.gui.until("told", () -> editor.status().startsWith("picture.png is neither a scene nor a model"));
        assertThat(editor.model().scene().objects()).hasSize(1);
    }

    @Test
    void overTheWelcomeFilesAreOpenedToo() {
        editor.gui.act(() -> editor.editor.welcome());
        Node welcome = editor.gui.node("#welcome");
        drop("#welcome", corner);
        editor.gui.until("it is open", () -> editor.status().contains("corner.obj"));
        assertThat(Gui.on(welcome::isVisible)).isFalse();
    }
}
