package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.fx.model.file.Recovery;
import cz.paprsek.fx.model.file.SceneSource;
import cz.paprsek.fx.model.typing.Manuscript;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import javafx.scene.control.ListView;
import javafx.scene.input.KeyCode;
import javafx.stage.FileChooser;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files as the window handles them. */
class FilesTest {
    private static final Scene BALL = Scene.EMPTY.withName("ball").plus(SceneObject.of(new Sphere(1)).named("ball"));

    @TempDir
    Path folder;

    private EditorGui editor;

    @BeforeEach
    void open() {
        editor = new EditorGui(folder.resolve("settings"), BALL);
    }

    @AfterEach
    void close() {
        editor.close();
    }

    /** What is written in the text of the scene stands in the file as it was written; what is not valid is neither lost nor saved unasked. */
    @Test
    void whatIsWrittenInTheTextIsSavedByteForByte() throws IOException {
        String text = "<!-- exam 3 -->\r\n<scene xmlns='urn:paprsek:scene:1'>\r\n  <camera direction=\"0 0 -1\" position='0 0 5'/>\r\n  <sphere radius=\"1.0\"/> <!-- cm -->\r\n</scene>\r\n";
        Path file = Files.writeString(folder.resolve("exam.xml"), text);
        editor.gui.act(() -> editor.editor.files().open(file));
        editor.gui.until("the scene is there", () -> editor.gui.stage().getTitle().startsWith("exam.xml"));
        editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.X);
        Manuscript manuscript = editor.editor.manuscript();
        editor.gui.until("the text is there", () -> manuscript.page().text().contains("cm"));
        editor.gui.act(() -> manuscript.write(manuscript.page().text().replace("cm", "mm").replace("1.0", "2.50")));
        editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
        String written = text.replace("cm", "mm").replace("1.0", "2.50");
        assertThat(Files.readString(file)).isEqualTo(written);
        editor.gui.act(() -> manuscript.write(manuscript.page().text().replace("2.50", "2.50 3")));
        assertThat(editor.gui.stage().getTitle()).startsWith("●");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
        assertThat(editor.text("#message")).startsWith("The text has a mistake in line 4");
        assertThat(Files.readString(file)).isEqualTo(written);
        assertThat(Gui.on(() -> editor.editor.files().mayLeave())).as("the user stays").isFalse();
        Recovery recovery = new Recovery(folder.resolve("settings"));
        editor.gui.act(() -> editor.editor.fault(new IllegalStateException("a crash")));
        Path copy = recovery.place(Optional.of(SceneSource.file(file)));
        editor.gui.until("kept aside", () -> Files.exists(copy.resolveSibling(copy.getFileName() + "-text")));
        assertThat(Recovery.textBeside(copy)).contains(written.replace("2.50", "2.50 3").replace("\r", ""));
        editor.gui.click("#xml-save-without");
        assertThat(Files.readString(file)).isEqualTo(written);
        assertThat(manuscript.page().text()).contains("2.50 3");
        assertThat(copy).doesNotExist();
        editor.gui.act(() -> editor.editor.fault(new IllegalStateException("another crash")));
        editor.gui.until("what is held is kept aside again", () -> Files.exists(copy.resolveSibling(copy.getFileName() + "-text")));
        editor.gui.act(manuscript::giveUp);
        for (String comment : List.of("in", "ft")) {
            editor.gui.act(() -> {
                manuscript.write(manuscript.page().text().replaceFirst("<!-- .. -->", "<!-- " + comment + " -->"));
                manuscript.flush();
                editor.editor.fault(new IllegalStateException("a crash after a comment"));
            });
            editor.gui.until("the comment is kept", () -> contents(copy).contains("<!-- " + comment + " -->"));
            assertThat(Recovery.textBeside(copy)).isEmpty();
        }
        editor.gui.act(editor.model()::undo);
        editor.gui.act(editor.model()::undo);
        editor.gui.act(editor.model()::undo);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
        assertThat(Files.readString(file)).isEqualTo(text);
    }

    /** Whoever looks for a model sees it without asking for another kind of file, also one that is called PART.STL; only scenes are saved. */
    @Test
    void modelsAreAmongWhatCanBeOpened() {
        Texts texts = Texts.in(Locale.ENGLISH);
        assertThat(SystemDialogs.toOpen(texts).get(0).getExtensions()).contains("*.xml", "*.stl", "*.STL", "*.obj", "*.ply", "*.gltf", "*.glb", "*.nff", "*.csg");
        assertThat(SystemDialogs.toSave(texts)).extracting(FileChooser.ExtensionFilter::getDescription).containsExactly("Scenes", texts.of("dialog.all"));
    }

    @Test
    void whatIsSavedIsWhatIsSeen() throws IOException, SceneFileException {
        Path file = folder.resolve("scene.xml");
        editor.dialogs.save = Optional.of(file);
        moveBall();
        assertThat(editor.gui.stage().getTitle()).isEqualTo("● Untitled – Paprsek");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
        assertThat(editor.dialogs.asked).containsExactly("save ball.xml");
        assertThat(editor.gui.stage().getTitle()).isEqualTo("scene.xml – Paprsek");
        assertThat(SceneFiles.read(file)).isEqualTo(editor.model().scene());
        assertThat(Files.readString(file)).contains("position=\"1 0 0\"");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(editor.model().scene()).isSameAs(BALL);
        assertThat(editor.gui.stage().getTitle()).startsWith("●");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
        assertThat(editor.dialogs.asked).hasSize(1);
        assertThat(SceneFiles.read(file)).isEqualTo(BALL);
    }

    /** What has been undone is not offered after a crash. */
    @Test
    void theCopyOfWhatIsUndoneIsForgotten() throws IOException {
        Path file = write("scene.xml", BALL);
        editor.gui.act(() -> editor.editor.files().open(file));
        editor.gui.until("the scene is there", () -> editor.gui.stage().getTitle().startsWith("scene.xml"));
        moveBall();
        editor.gui.act(() -> editor.editor.fault(new IllegalStateException("a crash")));
        Path copy = new Recovery(folder.resolve("settings")).place(Optional.of(SceneSource.file(file)));
        editor.gui.until("it is kept", () -> Files.exists(copy));
        editor.gui.act(editor.model()::undo);
        editor.gui.until("it is forgotten", () -> !Files.exists(copy));
    }

    @Test
    void aModelOfAnotherProgramIsOpenedAndSavedWithItsMeshes() throws IOException, SceneFileException {
        Path model = Files.writeString(folder.resolve("thing.csg"), "cube(size=[1,1,1]);\nlinear_extrude(height=1,twist=0,scale=[2,1]) { square(size=[1,1]); }\n");
        editor.dialogs.open = Optional.of(model);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.O);
        editor.gui.until("the model is open", () -> editor.model().scene().name().equals("thing"));
        assertThat(editor.model().scene().objects()).extracting(object -> object.shape().kind()).containsExactly("block", "mesh", "plane");
        assertThat(editor.gui.stage().getTitle()).startsWith("●");
        Path file = folder.resolve("saved.xml");
        editor.dialogs.save = Optional.of(file);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
        assertThat(folder.resolve("thing-1.obj")).exists();
        assertThat(SceneFiles.read(file)).isEqualTo(editor.model().scene());
    }

    @Test
    void commentsStayWhereTheyWereAndUndoGivesTheOldFileBack() throws IOException, SceneFileException {
        String text = """
                <!-- exam 3 -->
                <scene xmlns="urn:paprsek:scene:1">
                  <camera direction="0 0 -1" position='0 0 5'/> <!-- do not move -->
                  <sphere radius="1.0"/> <!-- radius in cm -->
                </scene>
                """;
        Path file = Files.writeString(folder.resolve("exam.xml"), text);
        editor.gui.act(() -> editor.editor.files().open(file));
        editor.gui.until("the scene is there", () -> editor.gui.stage().getTitle().startsWith("exam.xml"));
        moveBall();
        Recovery recovery = new Recovery(folder);
        Gui.on(() -> {
            recovery.keep(editor.editor.document().sourceProperty().get(), editor.model().scene(), editor.editor.document().text());
            return true;
        });
        String moved = text.replace("radius=\"1.0\"", "radius=\"1.0\" position=\"1 0 0\"");
        assertThat(recovery.place(Optional.of(SceneSource.file(file)))).hasContent(moved);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
        assertThat(file).hasContent(moved);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
        assertThat(file).hasContent(text);
        editor.dialogs.save = Optional.of(folder.resolve("copy.xml"));
        editor.gui.act(editor.editor.files()::saveAs);
        assertThat(folder.resolve("copy.xml")).hasContent(text);
    }

    @Test
    void openedFileIsShownAndRemembered() throws IOException {
        Path file = write("two.xml", BALL.plus(Light.at(1, 2, 3)));
        editor.dialogs.open = Optional.of(file);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.O);
        editor.gui.until("the scene is there", () -> editor.model().scene().lights().size() == 1);
        assertThat(editor.editor.settings().recent()).containsExactly(file);
        assertThat(editor.model().unsavedProperty().get()).isFalse();
    }

    @Test
    void problemsAreListedAndTheOldSceneStays() throws IOException {
        Path file = folder.resolve("bad.xml");
        Files.writeString(file, """
                <scene xmlns="urn:paprsek:scene:1">
                  <camera position="0 0 5" direction="0 0 -1"/>
                  <sphere radius="-1"/>
                  <sphere raduis="1"/>
                </scene>
                """);
        editor.gui.act(() -> editor.editor.files().open(file));
        editor.gui.until("problems are listed", () -> editor.gui.stage().getScene().lookup("#problems").isVisible());
        assertThat(((ListView<?>) editor.gui.node("#problem-list")).getItems()).hasSizeGreaterThanOrEqualTo(2)
                .anyMatch(line -> line.toString().startsWith("3:")).anyMatch(line -> line.toString().startsWith("4:"));
        assertThat(editor.model().scene()).isSameAs(BALL);
        editor.gui.click("#problems-close");
        assertThat(editor.gui.stage().getScene().lookup("#problems").isVisible()).isFalse();
        editor.gui.act(() -> editor.editor.files().open(file));
        editor.gui.until("problems are listed again", () -> editor.gui.stage().getScene().lookup("#problems").isVisible());
        editor.gui.keys(KeyCode.E);
        editor.gui.keys(KeyCode.ESCAPE);
        assertThat(editor.gui.stage().getScene().lookup("#problems").isVisible()).as("the explanation is closed first").isTrue();
        editor.gui.keys(KeyCode.ESCAPE);
        assertThat(editor.gui.stage().getScene().lookup("#problems").isVisible()).isFalse();
        editor.gui.act(() -> editor.editor.files().open(file));
        editor.gui.until("problems are listed once more", () -> editor.gui.stage().getScene().lookup("#problems").isVisible());
        editor.gui.act(() -> editor.editor.files().open(folder));
        editor.gui.until("the list of another file is gone", () -> !editor.gui.stage().getScene().lookup("#problems").isVisible());
    }

    /** Beside the scene, with what it needs; the scene itself stays where it is. */
    @Test
    void theSceneIsWrittenForPovRay() throws IOException {
        Path target = folder.resolve("ball.pov");
        editor.dialogs.save = Optional.of(target);
        editor.menu("file-export-pov");
        editor.gui.until("it is told", () -> editor.status().equals("ball.pov written for POV-Ray"));
        assertThat(target).content().contains("sphere {");
        assertThat(editor.dialogs.asked).containsExactly("pov ball.pov");
        assertThat(editor.model().unsavedProperty().get()).isFalse();
        editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.RENAME, "x"), scene -> scene.withSettings(scene.settings().withSamples(4))));
        editor.menu("file-export-pov");
        editor.gui.until("what is different is told", () -> editor.gui.stage().getScene().lookup("#message-bar").isVisible());
        assertThat(editor.text("#message")).startsWith("ball.pov written for POV-Ray, which does not show all as it is here: POV-Ray does not sample pixels");
        editor.dialogs.save = Optional.of(folder.resolve("none/ball.pov"));
        editor.menu("file-export-pov");
        editor.gui.until("why it is not written is told", () -> editor.status().endsWith("ball.pov: cannot be written, there is no such folder"));
    }

    @Test
    void missingFileIsToldInASentence() {
        editor.gui.act(() -> editor.editor.files().open(folder.resolve("nowhere.xml")));
        editor.gui.until("it is told", () -> editor.status().contains("nowhere.xml: no such file"));
        assertThat(editor.dialogs.faults).isEmpty();
    }

    @Test
    void unsavedChangesAreAskedAboutOnce() throws IOException {
        Path file = write("two.xml", BALL.plus(Light.at(1, 2, 3)));
        editor.gui.act(() -> editor.editor.files().newFrom("plain"));
        assertThat(editor.dialogs.asked).isEmpty();
        editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.ADD), scene -> scene.plus(Light.at(0, 0, 0))));
        Scene changed = editor.model().scene();
        editor.gui.act(() -> editor.editor.files().open(file));
        assertThat(editor.dialogs.asked).containsExactly("unsaved Untitled");
        assertThat(editor.model().scene()).isSameAs(changed);
        editor.dialogs.unsaved = Dialogs.Unsaved.DISCARD;
        editor.gui.act(() -> editor.editor.files().open(file));
        editor.gui.until("the scene is there", () -> editor.model().scene().lights().size() == 1);
    }

    @Test
    void closingAsksToSave() throws IOException, SceneFileException {
        Path file = folder.resolve("kept.xml");
        moveBall();
        editor.gui.act(editor.editor::quit);
        assertThat(Gui.on(() -> editor.gui.stage().isShowing())).isTrue();
        editor.dialogs.unsaved = Dialogs.Unsaved.SAVE;
        editor.dialogs.save = Optional.of(file);
        editor.gui.act(editor.editor::quit);
        assertThat(Gui.on(() -> editor.gui.stage().isShowing())).isFalse();
        assertThat(SceneFiles.read(file)).isEqualTo(editor.model().scene());
    }

    @Test
    void changeOnDiskIsTakenOverAsAStepIfNothingIsUnsaved() throws IOException {
        Path file = write("two.xml", BALL);
        openAndWait(file, 0);
        touch(write("two.xml", BALL.plus(Light.at(1, 2, 3))));
        editor.gui.act(() -> editor.editor.files().checkDisk());
        editor.gui.until("it is reloaded", () -> editor.model().scene().lights().size() == 1);
        assertThat(editor.model().unsavedProperty().get()).isFalse();
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(editor.model().scene().lights()).isEmpty();
    }

    @Test
    void changeOnDiskIsAskedAboutIfSomethingIsUnsaved() throws IOException {
        Path file = write("two.xml", BALL);
        openAndWait(file, 0);
        moveBall();
        touch(write("two.xml", BALL.plus(Light.at(1, 2, 3))));
        editor.gui.act(() -> editor.editor.files().checkDisk());
        editor.gui.until("it is asked about", () -> editor.text("#message").contains("two.xml was changed on disk"));
        assertThat(editor.model().scene().lights()).isEmpty();
        editor.gui.click("#disk-reload");
        editor.gui.until("it is reloaded", () -> editor.model().scene().lights().size() == 1);
    }

    /** Comments that others have written are not written over, nor are one's own left out. */
    @Test
    void commentsOnDiskAreAskedAboutIfTheTextWasWrittenInHere() throws IOException, SceneFileException {
        Path file = write("two.xml", BALL);
        openAndWait(file, 0);
        String text = Files.readString(file);
        Manuscript manuscript = editor.editor.manuscript();
        editor.gui.act(() -> manuscript.openProperty().set(true));
        editor.gui.until("the text is there", () -> manuscript.page().text().equals(text));
        editor.gui.act(() -> {
            manuscript.write(text.replace("</scene>", "<!-- mine -->\n</scene>"));
            manuscript.flush();
        });
        touch(Files.writeString(file, text.replace("</scene>", "<!-- theirs -->\n</scene>")));
        editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
        assertThat(editor.text("#message")).contains("somebody else has changed this file");
        assertThat(Files.readString(file)).contains("theirs").doesNotContain("mine");
        SceneSource.Kept theirs = SceneSource.file(file).read();
        assertThat(editor.editor.document().knows(theirs)).isFalse();
        // One question is enough: what looks at the disk now and then does not ask another.
        assertThat(editor.editor.document().hasChangedOnDisk()).isFalse();
        editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
        assertThat(Files.readString(file)).contains("theirs").doesNotContain("mine");
        editor.gui.click("#disk-keep");
        editor.gui.until("what is there may be written over", () -> editor.editor.document().knows(theirs));
        editor.gui.keys(KeyCode.CONTROL, KeyCode.S);
        assertThat(Files.readString(file)).contains("mine").doesNotContain("theirs");
    }

    @Test
    void sceneOfADatabaseGoesBackToItsPlace() throws IOException, SceneFileException {
        Path file = folder.resolve("database.xml");
        Scene other = Scene.EMPTY.withName("other");
        SceneFiles.writeAll(List.of(BALL, other), file);
        openAndWait(file, 0);
        assertThat(editor.gui.stage().getTitle()).isEqualTo("database.xml · ball – Paprsek");
        moveBall();
        editor.menu("file-save");
        assertThat(SceneFiles.readAll(file)).containsExactly(editor.model().scene(), other);
    }

    @Test
    void databaseIsNotOverwrittenWithOneScene() throws IOException, SceneFileException {
        Path file = folder.resolve("database.xml");
        SceneFiles.writeAll(List.of(BALL, Scene.EMPTY.withName("other")), file);
        editor.dialogs.save = Optional.of(file);
        editor.menu("file-save-as");
        assertThat(editor.status()).contains("database.xml is a database");
        assertThat(SceneFiles.readAll(file)).hasSize(2);
    }

    @Test
    void whatCannotBeWrittenIsToldWithAWayOut() {
        editor.dialogs.save = Optional.of(folder.resolve("no/such/folder/scene.xml"));
        editor.menu("file-save");
        assertThat(editor.text("#message")).contains("could not be saved").contains("no such folder");
        editor.dialogs.save = Optional.of(folder.resolve("scene.xml"));
        editor.gui.click("#save-elsewhere");
        assertThat(folder.resolve("scene.xml")).exists();
        assertThat(Gui.on(() -> editor.gui.stage().getScene().lookup("#message-bar").isVisible())).isFalse();
    }

    @Test
    void faultOfTheProgramKeepsTheSceneAndOffersToSaveIt() {
        moveBall();
        editor.dialogs.save = Optional.of(folder.resolve("rescued.xml"));
        editor.gui.act(() -> editor.editor.fault(new IllegalStateException("a fault made by a test")));
        assertThat(editor.dialogs.faults).hasSize(1);
        assertThat(folder.resolve("rescued.xml")).exists();
    }

    @Test
    void everyTemplateAndExampleOpens() {
        for (String name : Templates.NEW) {
            editor.menu("template-" + name);
            assertThat(editor.model().unsavedProperty().get()).isFalse();
            assertThat(editor.model().scene().settings().isAdaptive()).as("as many rays as it needs").isTrue();
        }
        for (String name : Templates.EXAMPLES) {
            editor.menu("example-" + name);
            assertThat(editor.model().scene().objects()).isNotEmpty();
        }
    }

    @Test
    void languageChangesWhileTheSceneStays() {
        moveBall();
        editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
        assertThat(editor.gui.stage().getTitle()).isEqualTo("● Bez názvu – Paprsek");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(editor.model().scene()).isSameAs(BALL);
        assertThat(editor.editor.settings().get("language")).contains("cs");
        assertThat(editor.dialogs.faults).isEmpty();
    }

    @Test
    void copyAndPasteGoesThroughText() {
        editor.gui.act(() -> editor.model().select(ScenePath.body(0)));
        editor.gui.keys(KeyCode.CONTROL, KeyCode.C);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.V);
        assertThat(editor.model().scene().objects()).extracting(SceneObject::name).containsExactly("ball", "ball 2");
        assertThat(Gui.on(() -> javafx.scene.input.Clipboard.getSystemClipboard().getString())).contains("<sphere name=\"ball\"");
        editor.gui.keys(KeyCode.DELETE);
        assertThat(editor.model().scene().objects()).hasSize(1);
    }

    private static String contents(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException gone) {
            return "";
        }
    }

    private void moveBall() {
        editor.gui.act(() -> editor.model().edit(
                Label.of(Label.Edit.MOVE, "ball"), scene -> Moves.translated(scene, Set.of(ScenePath.body(0)), Vec3.X)));
    }

    private void openAndWait(Path file, int lights) {
        editor.gui.act(() -> editor.editor.files().open(file));
        editor.gui.until("the file is open", () -> editor.editor.document().sourceProperty().get().isPresent());
        assertThat(editor.model().scene().lights()).hasSize(lights);
    }

    private Path write(String name, Scene scene) throws IOException {
        Path file = folder.resolve(name);
        SceneFiles.write(scene, file);
        return file;
    }

    /** Makes sure that the time of the file is another one, however coarse the clock of the file system. */
    private static void touch(Path file) throws IOException {
        Files.setLastModifiedTime(file, FileTime.from(Instant.now().plusSeconds(10)));
    }
}
