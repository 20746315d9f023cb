package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DatabaseFileTest {
    private static final Scene ONE = Scene.EMPTY.withName("one");
    private static final Scene TWO = Scene.EMPTY.withName("two");

    @TempDir
    Path folder;

    private Path path;

    @BeforeEach
    void writeADatabase() throws Exception {
        path = folder.resolve("db.xml");
        DatabaseFile.create(path).save(SceneDatabase.EMPTY.plus(ONE, TWO));
    }

    @Test
    void whatIsSavedIsReadAgainAndNothingElseIsLeftInTheFolder() throws Exception {
        assertThat(DatabaseFile.open(path).database().scenes()).containsExactly(ONE, TWO);
        assertThat(WayIn.all(Files.readString(path)).contents()).contains(new SceneFiles.Contents(List.of(ONE, TWO), true));
        assertThat(SceneFiles.readDatabase(path)).isEqualTo(DatabaseFile.open(path).database());
        assertThat(folder.toFile().list()).containsExactly("db.xml");
    }

    @Test
    void scenesThatOthersChangedMeanwhileStayAsTheyMadeThem() throws Exception {
        DatabaseFile mine = DatabaseFile.open(path);
        DatabaseFile.update(path, database -> database.rename("two", "deux"));
        DatabaseFile saved = mine.save(mine.database().replace("one", ONE.withDescription("mine")));
        assertThat(saved.database().scenes()).containsExactly(ONE.withDescription("mine"), TWO.withName("deux"));
        assertThat(saved.save(saved.database().without(List.of("one"))).database().names()).containsExactly("deux");
    }

    @Test
    void whereBothChangedASceneNothingIsWritten() throws Exception {
        DatabaseFile mine = DatabaseFile.open(path);
        DatabaseFile.update(path, database -> database.replace("one", ONE.withDescription("theirs")));
        String before = Files.readString(path);
        assertThatThrownBy(() -> mine.save(mine.database().without(List.of("one")))).isInstanceOf(DatabaseConflictException.class)
                .hasMessage(path + ": somebody else has changed this file since it was read, and both changed \"one\"; nothing is written");
        assertThat(path).hasContent(before);
    }

    @Test
    void aFileThatOthersMadeMeanwhileIsNotOverwritten() throws Exception {
        Path fresh = folder.resolve("fresh.xml");
        DatabaseFile mine = DatabaseFile.create(fresh);
        SceneFiles.writeAll(List.of(ONE), fresh);
        assertThat(mine.save(SceneDatabase.EMPTY.plus(TWO)).database().names()).containsExactly("one", "two");
    }

    @Test
    void aFileThatOthersBrokeIsNotOverwritten() throws Exception {
        DatabaseFile mine = DatabaseFile.open(path);
        Files.writeString(path, "not XML");
        assertThatThrownBy(() -> mine.save(mine.database().plus(Scene.EMPTY.withName("three")))).isInstanceOf(SceneFileException.class);
        assertThat(path).hasContent("not XML");
    }

    @Test
    void manyWhoChangeAFileAtOnceLoseNothing() throws Exception {
        ExecutorService people = Executors.newFixedThreadPool(6);
        List<Callable<DatabaseFile>> changes = new ArrayList<>();
        for (int i = 0; i < 24; i++) {
            Scene scene = Scene.EMPTY.withName("scene " + i);
            changes.add(() -> DatabaseFile.update(path, database -> database.plus(scene)));
        }
        for (Future<DatabaseFile> change : people.invokeAll(changes)) {
            change.get();
        }
        people.shutdown();
        assertThat(SceneFiles.readDatabase(path).size()).isEqualTo(26);
        assertThat(folder.toFile().list()).containsExactly("db.xml");
    }

    /** The platform's parsers tell standard error of such bytes, unless they are told not to. */
    @Test
    void whetherABinaryFileIsADatabaseIsAskedInSilence() throws Exception {
        PrintStream before = System.err;
        ByteArrayOutputStream told = new ByteArrayOutputStream();
        System.setErr(new PrintStream(told, true, StandardCharsets.UTF_8));
        try {
            assertThat(SceneFiles.isDatabase(Files.write(folder.resolve("binary.xml"), new byte[] {'<', (byte) 0xF0, (byte) 0x80, 'a'}))).isFalse();
        } finally {
            System.setErr(before);
        }
        assertThat(told.toString(StandardCharsets.UTF_8)).doesNotContain("Error");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\u0000', value = {
        "true  | <database xmlns='urn:paprsek:scene:1'/>",
        "true  | <!-- <scene> --><database xmlns='urn:paprsek:scene:1'>",
        "true  | <scene:database xmlns:scene='urn:paprsek:scene:1'/>",
        "false | <scene xmlns='urn:paprsek:scene:1'/>",
        "false | <?xml version='1.0'?><!-- <database> --><scene>",
        "false | <scene.database xmlns='urn:paprsek:scene:1'/>",
        "false | <scene",
        "false | <database/>",
        "false | </database>"})
    void whetherAFileIsADatabaseIsToldByItsFirstElement(boolean isDatabase, String text) throws Exception {
        assertThat(SceneFiles.isDatabase(Files.writeString(folder.resolve("a.xml"), text.replace('\'', '"')))).isEqualTo(isDatabase);
    }

    @Test
    void aSceneIsNotTurnedIntoADatabase() throws Exception {
        Path file = folder.resolve("scene.xml");
        SceneFiles.write(Scene.EMPTY, file);
        assertThatThrownBy(() -> DatabaseFile.open(file)).hasMessage(file + ": this is a scene, not a database; it can be added to one");
        assertThat(SceneFiles.isDatabase(file)).isFalse();
        assertThat(SceneFiles.isDatabase(path)).isTrue();
        assertThat(SceneFiles.readDatabase(file).names()).as("named after the file").containsExactly("scene");
    }

    @Test
    void scenesWithoutANameOrWithTheSameAreProblemsOfTheFile() throws IOException {
        String camera = "<camera position=\"0 1 5\" direction=\"0 0 -1\"/></scene>";
        Files.writeString(path, "<database xmlns=\"urn:paprsek:scene:1\">\n<scene name=\"a\">" + camera + "\n<scene>" + camera + "\n<scene name=\"a\">"
                + camera + "</database>");
        assertThat(WayIn.all(Files.readString(path)).problems()).containsExactly("3:1: a scene in a database needs a name, to be found by",
                "4:8: there is already a scene named \"a\"; give one of them another name");
        assertThatThrownBy(() -> DatabaseFile.open(path)).hasMessage(path + ":3:1: a scene in a database needs a name, to be found by\n"
                + path + ":4:8: there is already a scene named \"a\"; give one of them another name");
    }

    @Test
    void aFolderThatDoesNotExistIsNamed() {
        Path nowhere = folder.resolve("none/db.xml");
        assertThatThrownBy(() -> DatabaseFile.create(nowhere).save(SceneDatabase.EMPTY)).hasMessage(nowhere + ": cannot be written, there is no such folder");
        assertThatThrownBy(() -> DatabaseFile.open(nowhere)).hasMessage(nowhere + ": no such file");
    }
}
