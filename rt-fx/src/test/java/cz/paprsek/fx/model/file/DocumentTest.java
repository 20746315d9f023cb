package cz.paprsek.fx.model.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.TestScenes;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import cz.paprsek.xml.SceneText;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DocumentTest {
    /** No process has this number: the largest that a system gives is far below. */
    private static final long DEAD = 999_999_999_999L;

    @TempDir
    Path folder;

    private final Scene kitchen = TestScenes.kitchen().withName("kitchen");

    @Test
    void sourceOfADatabaseIsItsFirstScene() throws IOException, SceneFileException {
        Path file = folder.resolve("d.xml");
        SceneFiles.writeAll(List.of(kitchen, Scene.EMPTY.withName("empty")), file);
        SceneSource source = SceneSource.of(file);
        assertThat(source.title()).isEqualTo("d.xml · kitchen");
        assertThat(source.read().scene()).isEqualTo(kitchen);
    }

    @Test
    void renamedSceneStaysAtItsPlaceInADatabase() throws IOException, SceneFileException {
        Path file = folder.resolve("d.xml");
        SceneFiles.writeAll(List.of(kitchen, Scene.EMPTY.withName("empty")), file);
        SceneSource after = SceneSource.of(file).write(kitchen.withName("cellar"), Optional.of(kitchen), KeptText.NONE).source();
        assertThat(after.inDatabase()).contains("cellar");
        assertThat(SceneFiles.readDatabase(file).names()).containsExactlyInAnyOrder("cellar", "empty");
        assertThat(after.read().scene().name()).isEqualTo("cellar");
    }

    @Test
    void sceneTakesItsTextFromADatabaseToAFileAndBack() throws IOException, SceneFileException {
        Path database = folder.resolve("d.xml");
        Files.writeString(database, """
                <database xmlns='urn:paprsek:scene:1'>
                  <!-- exam -->
                  <scene name='a'> <!-- one -->
                    <camera direction='0 0 -1' position='0 0 5.0'/>
                  </scene>
                </database>
                """);
        SceneSource.Kept kept = SceneSource.of(database).read();
        SceneSource own = SceneSource.file(folder.resolve("own.xml"));
        SceneSource.Kept moved = own.write(kept.scene().withDescription("new"), Optional.empty(), kept.text());
        String text = """
                <?xml version="1.0" encoding="UTF-8"?>
                <!-- exam -->
                <scene xmlns="urn:paprsek:scene:1" name='a'> <!-- one -->
                  <description>new</description>
                  <camera direction='0 0 -1' position='0 0 5.0'/>
                </scene>
                """;
        assertThat(own.file()).hasContent(text);
        SceneSource.inDatabase(database, "b").write(moved.scene().withName("b"), Optional.empty(), moved.text());
        assertThat(Files.readString(database)).endsWith("""
                  </scene>
                  <!-- exam -->
                  <scene name='b'> <!-- one -->
                    <description>new</description>
                    <camera direction='0 0 -1' position='0 0 5.0'/>
                  </scene>
                </database>
                """);
    }

    @Test
    void emptyDatabaseAndVanishedSceneAreToldInASentence() throws IOException {
        Path file = folder.resolve("d.xml");
        SceneFiles.writeAll(List.of(), file);
        assertThatThrownBy(() -> SceneSource.of(file)).isInstanceOf(IOException.class).hasMessageContaining("no scene in this database");
        assertThatThrownBy(() -> SceneSource.inDatabase(file, "gone").read()).isInstanceOf(IOException.class)
                .hasMessageContaining("no scene named \"gone\"");
    }

    @Test
    void whatMovesStaysAsItIsWrittenWhenAnythingElseIsSaved() throws IOException, SceneFileException {
        Path file = folder.resolve("moving.xml");
        String text = """
                <scene xmlns='urn:paprsek:scene:1'>
                  <param name="h" value="1"/>
                  <camera position='0 0 5' direction='0 0 -1'/>
                  <sphere name="ball" radius="1" position="0 {h+t} 0"/>
                  <animate target='ball'  attribute='radius'> <!-- grows -->
                    <key t='0' value='1' ease="smooth"/> <key t="{h}" value='2.0'/>
                  </animate>
                  <animate target="param:h" attribute="value"><key t="0" value="1"/></animate>
                </scene>
                """;
        Files.writeString(file, text);
        Document document = new Document(new EditorModel(kitchen));
        document.opened(SceneSource.of(file).read());
        document.model().edit(Label.of(Label.Edit.CHANGE), scene -> scene.withCamera(scene.camera().withFovy(30)));
        document.save(SceneSource.file(file));
        assertThat(file).hasContent(text.replace("direction='0 0 -1'/>", "direction='0 0 -1' fovy=\"30\"/>"));
        assertThatThrownBy(() -> document.model().edit(Label.of(Label.Edit.DELETE), scene -> scene.withObjects(List.of()))).hasMessageStartingWith("nothing in this scene is called \"ball\"");
    }

    @Test
    void failedSaveLeavesEverythingAsItWas() {
        Document document = new Document(new EditorModel(kitchen));
        document.model().edit(Label.of(Label.Edit.RENAME), scene -> scene.withName("cellar"));
        assertThatThrownBy(() -> document.save(SceneSource.file(folder.resolve("no/folder.xml")))).isInstanceOf(IOException.class);
        assertThat(document.sourceProperty().get()).isEmpty();
        assertThat(document.model().unsavedProperty().get()).isTrue();
    }

    @Test
    void copyOfAnUnsavedSceneIsFoundOnceItsWriterIsDead() throws IOException, SceneFileException {
        Optional<SceneSource> source = Optional.of(SceneSource.file(folder.resolve("lens.xml")));
        Recovery alive = new Recovery(folder);
        alive.keep(source, kitchen, KeptText.NONE);
        assertThat(alive.left(source)).isEmpty();
        new Recovery(folder, DEAD).keep(source, kitchen, KeptText.NONE);
        Path left = alive.left(source).orElseThrow();
        assertThat(SceneFiles.read(left)).isEqualTo(kitchen);
        assertThat(alive.left(Optional.of(SceneSource.file(folder.resolve("other.xml"))))).isEmpty();
        assertThat(alive.left(Optional.empty())).isEmpty();
        alive.discard(source);
        assertThat(alive.place(source)).doesNotExist();
    }

    @Test
    void whatWasWrittenInTheTextIsThereAfterACrashAndGoesIntoTheFile() throws IOException, SceneFileException {
        String text = "<scene xmlns='urn:paprsek:scene:1'>\r\n  <camera position='0 0 5.0' direction='0 0 -1'/> <!-- old -->\r\n</scene>\r\n";
        Path file = Files.writeString(folder.resolve("lens.xml"), text);
        SceneSource source = SceneSource.file(file);
        Document document = new Document(new EditorModel(kitchen));
        document.opened(source.read());
        SceneText now = SceneText.of(document.text().original(), document.model().scene());
        SceneText typed = now.typed(now.characters().replace("old", "new").replace("5.0", "5.00"), Assets.none());
        document.model().editState(Label.of(Label.Edit.WRITE, "XML"), state -> state.withScene(typed.scene()).withTyped(Optional.of(typed.kept())));
        new Recovery(folder, DEAD).keep(Optional.of(source), document.model().scene(), document.text());
        Document next = new Document(new EditorModel(kitchen));
        next.opened(source.read());
        next.recovered(Optional.of(source), Recovery.read(new Recovery(folder).left(Optional.of(source)).orElseThrow()));
        assertThat(next.model().unsavedProperty().get()).isTrue();
        next.save(source);
        assertThat(Files.readString(file)).isEqualTo(text.replace("old", "new").replace("5.0", "5.00"));
        assertThat(next.model().unsavedProperty().get()).isFalse();
    }

    /** Undone after saving, also if it was no more than a comment, and also done again. */
    @Test
    void whatWasWrittenInASceneOfADatabaseIsUndoneThere() throws IOException, SceneFileException {
        String text = """
                <database xmlns='urn:paprsek:scene:1'>
                  <scene name='a'> <!-- one -->
                    <camera direction='0 0 -1' position='0 0 5.0'/>
                  </scene>
                  <scene name='b'><camera direction='0 0 -1' position='0 0 5'/></scene> <!-- two -->
                </database>
                """.replace("\n", "\r\n");
        Path file = Files.writeString(folder.resolve("d.xml"), text);
        Document document = new Document(new EditorModel(kitchen));
        document.opened(SceneSource.of(file).read());
        for (String word : List.of("three", "four")) {
            SceneText now = SceneText.of(document.text().original(), document.model().scene());
            SceneText typed = now.typed(now.characters().replaceFirst("<!-- \\w+ -->", "<!-- " + word + " -->"), Assets.none());
            document.model().editState(Label.of(Label.Edit.WRITE, "XML"), state -> state.withScene(typed.scene()).withTyped(Optional.of(typed.kept())));
            document.save(document.sourceProperty().get().orElseThrow());
            assertThat(Files.readString(file)).isEqualTo(text.replace("one", word));
        }
        for (String word : List.of("three", "one")) {
            document.model().undo();
            assertThat(document.model().unsavedProperty().get()).isTrue();
            assertThat(SceneText.of(document.text().original(), document.model().scene()).characters()).contains("<!-- " + word + " -->");
            document.save(document.sourceProperty().get().orElseThrow());
            assertThat(Files.readString(file)).isEqualTo(text.replace("one", word));
            assertThat(document.model().unsavedProperty().get()).isFalse();
        }
        document.model().redo();
        document.save(document.sourceProperty().get().orElseThrow());
        assertThat(Files.readString(file)).isEqualTo(text.replace("one", "three"));
    }

    @Test
    void commentsOfADatabaseAreThereAfterACrash() throws IOException, SceneFileException {
        String text = "<database xmlns='urn:paprsek:scene:1'>\n  <scene name='a'> <!-- one -->\n    <camera direction='0 0 -1' position='0 0 5.0'/>\n  </scene>\n</database>\n";
        Path file = Files.writeString(folder.resolve("d.xml"), text);
        SceneSource source = SceneSource.of(file);
        SceneSource.Kept kept = source.read();
        for (KeptText known : List.of(kept.text(), KeptText.NONE)) {
            new Recovery(folder, DEAD).keep(Optional.of(source), kept.scene().withDescription("new"), known);
            Document next = new Document(new EditorModel(kitchen));
            next.recovered(Optional.of(source), Recovery.read(new Recovery(folder).left(Optional.of(source)).orElseThrow()));
            next.save(source);
            assertThat(Files.readString(file)).contains("<!-- one -->", "5.0'", "<description>new");
            Files.writeString(file, text);
        }
    }

    @Test
    void sceneWithoutAFileHasItsCopyInTheProgramsFolder() throws IOException {
        Path own = folder.resolve("made/when/needed");
        new Recovery(own, DEAD).keep(Optional.empty(), kitchen, KeptText.NONE);
        assertThat(new Recovery(own).left(Optional.empty())).isPresent();
    }

    @Test
    void scenesOfADatabaseHaveCopiesOfTheirOwn() throws IOException {
        Path file = folder.resolve("d.xml");
        new Recovery(folder, DEAD).keep(Optional.of(SceneSource.inDatabase(file, "a")), kitchen, KeptText.NONE);
        assertThat(new Recovery(folder).left(Optional.of(SceneSource.inDatabase(file, "b")))).isEmpty();
        assertThat(new Recovery(folder).left(Optional.of(SceneSource.inDatabase(file, "a")))).isPresent();
    }

    @Test
    void settingsAreThereAtTheNextStart() {
        List<String> faults = new ArrayList<>();
        Settings settings = new Settings(folder.resolve("s"), faults::add);
        settings.set("language", "cs");
        for (int i = 0; i < 12; i++) {
            settings.addRecent(folder.resolve("scene" + i + ".xml"));
        }
        settings.addRecent(folder.resolve("scene5.xml"));
        Settings next = new Settings(folder.resolve("s"), faults::add);
        assertThat(next.get("language")).contains("cs");
        assertThat(next.recent()).hasSize(10).startsWith(folder.resolve("scene5.xml"), folder.resolve("scene11.xml")).doesNotHaveDuplicates();
        assertThat(faults).isEmpty();
    }

    @Test
    void damagedOrUnwritableSettingsAreToldAndDoNoHarm() throws IOException {
        List<String> faults = new ArrayList<>();
        Files.writeString(folder.resolve("editor.properties"), "language=\\u00zz");
        assertThat(new Settings(folder, faults::add).get("language")).isEmpty();
        Files.writeString(folder.resolve("file"), "");
        new Settings(folder.resolve("file"), faults::add).set("theme", "DARK");
        assertThat(faults).hasSize(2);
    }

    @Test
    void everySystemHasItsPlaceForSettings() {
        Path home = Path.of("/home/jana");
        assertThat(Settings.folder(Map.of(), "Linux", home)).isEqualTo(Path.of("/home/jana/.config/paprsek"));
        assertThat(Settings.folder(Map.of("XDG_CONFIG_HOME", "/etc/mine"), "Linux", home)).isEqualTo(Path.of("/etc/mine/paprsek"));
        assertThat(Settings.folder(Map.of(), "Mac OS X", home)).isEqualTo(Path.of("/home/jana/Library/Application Support/Paprsek"));
        assertThat(Settings.folder(Map.of("APPDATA", "/data"), "Windows 11", home)).isEqualTo(Path.of("/data/Paprsek"));
    }
}
