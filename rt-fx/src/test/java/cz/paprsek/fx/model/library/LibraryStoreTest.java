package cz.paprsek.fx.model.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import cz.paprsek.cli.Main;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.file.Document;
import cz.paprsek.fx.model.file.SceneSource;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.xml.DatabaseFile;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LibraryStoreTest {
    @TempDir
    Path folder;

    private final List<String> faults = new ArrayList<>();
    private final Library mine = new Library();
    private final LibraryStore store = new LibraryStore(mine, Runnable::run, Runnable::run);
    private Path path = Path.of("");

    @BeforeEach
    void write() throws Exception {
        path = folder.resolve("db.xml");
        SceneFiles.writeAll(List.of(Scene.EMPTY.withName("a"), Scene.EMPTY.withName("b"), Scene.EMPTY.withName("c")), path);
        store.open(path, faults::add);
        assertThat(faults).isEmpty();
    }

    private SceneDatabase onDisk() throws Exception {
        return SceneFiles.readDatabase(path);
    }

    private void others(String name, Scene scene) throws Exception {
        DatabaseFile.update(path, database -> database.replace(name, scene));
    }

    @Test
    void everyEditAndUndoIsInTheFileAtOnce() throws Exception {
        mine.rename("a", "first");
        assertThat(onDisk().names()).containsExactly("first", "b", "c");
        mine.delete(List.of("b", "c"));
        assertThat(onDisk().names()).containsExactly("first");
        mine.undo();
        assertThat(onDisk().names()).containsExactly("first", "b", "c");
        assertThat(mine.unsavedProperty().get()).isFalse();
        assertThat(store.flush()).isTrue();
    }

    @Test
    void whatOthersChangeComesInAndOutlivesUndo() throws Exception {
        mine.tag(List.of("a"), "mine");
        others("b", Scene.EMPTY.withName("theirs"));
        mine.tag(List.of("c"), "mine");
        assertThat(mine.database().names()).containsExactlyInAnyOrder("a", "theirs", "c");
        mine.undo();
        mine.undo();
        assertThat(mine.database().scenes()).allMatch(scene -> scene.tags().isEmpty());
        assertThat(onDisk().names()).containsExactlyInAnyOrder("a", "theirs", "c");
    }

    @Test
    void aChangedFileIsNoticed() throws Exception {
        others("b", Scene.EMPTY.withName("theirs, and longer"));
        store.checkDisk();
        assertThat(mine.database().names()).contains("theirs, and longer");
        assertThat(mine.undoableProperty().get()).isEmpty();
    }

    @Test
    void twoChangesOfOneSceneAreRefusedUntilOneIsUndone() throws Exception {
        others("b", Scene.EMPTY.withName("b").withDescription("theirs"));
        mine.tag(List.of("b"), "mine");
        assertThat(store.refusalProperty().get()).contains("somebody else", "\"b\"", "nothing is written");
        assertThat(mine.unsavedProperty().get()).isTrue();
        assertThat(store.flush()).isFalse();
        assertThat(onDisk().get("b").description()).isEqualTo("theirs");
        mine.undo();
        store.checkDisk();
        assertThat(store.refusalProperty().get()).isEmpty();
        assertThat(mine.database().get("b").description()).isEqualTo("theirs");
    }

    @Test
    void aRefusalIsSaidWhileItIsTriedAgainAndNoLongerWhenItIsIn() throws Exception {
        Queue<Runnable> background = new ArrayDeque<>();
        Library slow = new Library();
        LibraryStore later = new LibraryStore(slow, background::add, Runnable::run);
        later.open(path, faults::add);
        background.remove().run();
        others("b", Scene.EMPTY.withName("b").withDescription("theirs"));
        slow.tag(List.of("b"), "mine");
        background.remove().run();
        String refused = later.refusalProperty().get();
        assertThat(refused).contains("\"b\"");
        others("b", Scene.EMPTY.withName("b").withDescription("theirs, once more"));
        later.checkDisk();
        assertThat(later.refusalProperty().get()).isEqualTo(refused);
        background.remove().run();
        assertThat(later.refusalProperty().get()).contains("\"b\"");
        others("b", Scene.EMPTY.withName("b"));
        later.checkDisk();
        background.remove().run();
        assertThat(later.refusalProperty().get()).isEmpty();
        assertThat(onDisk().get("b").tags()).containsExactly("mine");
    }

    @Test
    void aRefusedChangeCanBeGivenUp() throws Exception {
        others("b", Scene.EMPTY.withName("b").withDescription("theirs"));
        mine.tag(List.of("b"), "mine");
        store.reload();
        assertThat(store.refusalProperty().get()).isEmpty();
        assertThat(mine.database()).isEqualTo(onDisk());
    }

    @Test
    void undoOfWhatOthersChangedSinceIsRefused() throws Exception {
        mine.tag(List.of("b"), "mine");
        others("b", Scene.EMPTY.withName("b").withDescription("theirs"));
        store.checkDisk();
        assertThatIllegalArgumentException().isThrownBy(mine::undo).withMessageContaining("\"b\"");
        assertThat(mine.undoableProperty().get()).isPresent();
        assertThat(onDisk().get("b").description()).isEqualTo("theirs");
    }

    @Test
    void editsDuringAWriteAreWrittenNext() throws Exception {
        Queue<Runnable> tasks = new ArrayDeque<>();
        Library library = new Library();
        LibraryStore slow = new LibraryStore(library, tasks::add, Runnable::run);
        slow.open(path, faults::add);
        tasks.remove().run();
        library.rename("a", "1");
        library.rename("b", "2");
        DatabaseFile.update(path, database -> database.rename("c", "3"));
        while (!tasks.isEmpty()) {
            tasks.remove().run();
        }
        assertThat(onDisk().names()).containsExactlyInAnyOrder("1", "2", "3");
        library.rename("1", "one");
        library.rename("2", "two");
        assertThat(slow.flush()).isTrue();
        assertThat(onDisk().names()).containsExactlyInAnyOrder("one", "two", "3");
        assertThat(faults).isEmpty();
    }

    @Test
    void aNewDatabaseIsAFileAtOnceAndNeverReplacesOne() throws Exception {
        Path fresh = folder.resolve("fresh.xml");
        store.create(fresh, faults::add);
        assertThat(SceneFiles.readDatabase(fresh).size()).isZero();
        mine.add(Scene.EMPTY);
        assertThat(SceneFiles.readDatabase(fresh).names()).containsExactly("Scene");
        store.create(path, faults::add);
        assertThat(mine.database().names()).containsExactly("a", "b", "c");
        SceneFiles.write(Scene.EMPTY, folder.resolve("scene.xml"));
        store.create(folder.resolve("scene.xml"), faults::add);
        assertThat(faults).singleElement().asString().contains("this is a scene, not a database");
    }

    @Test
    void twoEditorsAndTheCommandLineAtOnceLoseNothing() throws Exception {
        int each = 15;
        List<Process> commands = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            Path scene = folder.resolve("command" + i + ".xml");
            SceneFiles.write(Scene.EMPTY.withName("command " + i), scene);
            commands.add(command("db", "add", path.toString(), scene.toString()));
        }
        ExecutorService threads = Executors.newFixedThreadPool(2);
        Library other = new Library();
        LibraryStore theirStore = new LibraryStore(other, Runnable::run, Runnable::run);
        theirStore.open(path, faults::add);
        var one = threads.submit(() -> edits(mine, "mine", each));
        var two = threads.submit(() -> edits(other, "theirs", each));
        one.get();
        two.get();
        threads.shutdown();
        for (Process command : commands) {
            // Until both have written, this goes on changing what they change.
            while (command.isAlive()) {
                mine.tag(List.of("a"), mine.database().get("a").tags().isEmpty() ? "busy" : "");
            }
            assertThat(command.exitValue()).isZero();
        }
        assertThat(store.flush()).isTrue();
        assertThat(theirStore.flush()).isTrue();
        assertThat(faults).isEmpty();
        assertThat(onDisk().size()).isEqualTo(3 + 2 * each + commands.size());
        assertThat(onDisk().names()).contains("command 0", "command 1", "mine14", "theirs14");
        store.checkDisk();
        assertThat(mine.database()).isEqualTo(onDisk());
    }

    private static Process command(String... arguments) throws IOException {
        List<String> words = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), Main.class.getName()));
        words.addAll(List.of(arguments));
        return new ProcessBuilder(words).redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
    }

    private static boolean edits(Library library, String name, int count) {
        for (int i = 0; i < count; i++) {
            library.add(Scene.EMPTY.withName(name + i).plus(Light.at(i, 0, 0)));
        }
        return true;
    }

    @Test
    void theSceneInTheEditorFollowsItsNameInTheLibrary() throws Exception {
        Document document = new Document(new EditorModel(Scene.EMPTY));
        LibraryLink link = new LibraryLink(mine, document);
        document.opened(SceneSource.inDatabase(path, "b").read());
        document.model().edit(Label.of(Label.Edit.ADD), scene -> scene.plus(Light.at(1, 2, 3)));
        mine.rename("b", "beach");
        mine.tag(List.of("beach"), "sun");
        assertThat(link.name()).contains("beach");
        assertThat(document.model().scene().name()).isEqualTo("beach");
        assertThat(document.model().unsavedProperty().get()).isTrue();
        document.save(document.sourceProperty().get().orElseThrow());
        store.checkDisk();
        assertThat(mine.database().names()).containsExactly("a", "beach", "c");
        assertThat(mine.database().get("beach")).isEqualTo(document.model().scene());
        assertThat(document.model().scene().tags()).containsExactly("sun");
        mine.rename("beach", "b");
        assertThat(document.model().unsavedProperty().get()).isFalse();
        assertThat(document.sourceProperty().get().flatMap(SceneSource::inDatabase)).isEqualTo(Optional.of("b"));
    }

    @Test
    void aSceneThatOthersChangedIsNotOverwrittenByTheEditor() throws Exception {
        Document document = new Document(new EditorModel(Scene.EMPTY));
        SceneSource source = SceneSource.inDatabase(path, "b");
        document.opened(source.read());
        document.model().edit(Label.of(Label.Edit.ADD), scene -> scene.plus(Light.at(1, 2, 3)));
        others("b", Scene.EMPTY.withName("b").withDescription("theirs"));
        assertThatIllegalArgumentException().isThrownBy(() -> document.save(source)).withMessageContaining("somebody else has changed the scene \"b\"");
        assertThat(onDisk().get("b").description()).isEqualTo("theirs");
        document.noticeDisk(source.read());
        document.save(source);
        assertThat(onDisk().get("b").lights()).hasSize(1);
        assertThat(Files.size(path)).isPositive();
    }
}
