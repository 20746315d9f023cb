package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.library.Library;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.DatabaseFile;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Labeled;
import javafx.scene.control.ListView;
import javafx.scene.control.TabPane;
import javafx.scene.control.TableColumn;
import javafx.scene.control.TableView;
import javafx.scene.control.TextField;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LibraryWindowTest {
    @TempDir
    Path folder;

    private Path path = Path.of("");
    private EditorGui editor;
    private Gui gui;
    private Library library;
    private int all;

    @BeforeEach
    void openTheLibrary() throws Exception {
        path = folder.resolve("database.xml");
        Files.copy(Path.of("../scenes/database.xml"), path);
        all = SceneFiles.readDatabase(path).size();
        editor = new EditorGui(folder.resolve("settings"), Scene.EMPTY.withName("mine").plus(Light.at(1, 2, 3)));
        library = editor.editor.library().library();
        editor.dialogs.open = Optional.of(path);
        editor.menu("file-library");
        gui = Gui.open(() -> editor.editor.library().stage().orElseThrow());
        gui.click("#library-open");
        gui.until("the scenes are there", () -> scenes() == all);
        gui.pulse();
    }

    @AfterEach
    void close() {
        editor.close();
    }

    /** How many are shown; for JavaFX's thread. */
    private int scenes() {
        return ((ListView<?>) gui.stage().getScene().lookup("#library-scenes")).getItems().stream().mapToInt(line -> ((List<?>) line).size()).sum();
    }

    private List<Node> tiles() {
        return Gui.on(() -> gui.stage().getScene().getRoot().lookupAll(".scene-tile").stream().filter(Node::isVisible)
                .sorted((a, b) -> Double.compare(a.localToScene(0, 0).getY() * 10 + a.localToScene(0, 0).getX(),
                        b.localToScene(0, 0).getY() * 10 + b.localToScene(0, 0).getX())).toList());
    }

    /** For JavaFX's thread. */
    private String text(String selector) {
        return ((Labeled) gui.stage().getScene().lookup(selector)).getText();
    }

    private String textNow(String selector) {
        return Gui.on(() -> text(selector));
    }

    private void type(String selector, String text) {
        TextField field = (TextField) gui.node(selector);
        gui.click(field);
        gui.act(() -> field.setText(text));
        gui.keys(KeyCode.ENTER);
    }

    /** The first ones; all would take long while others keep the processor busy. */
    private void picturesAreThere() {
        gui.until("there are pictures", () -> gui.stage().getScene().getRoot().lookupAll(".thumbnail").stream()
                .map(ImageView.class::cast).filter(view -> view.getImage() != null).count() >= 4);
    }

    @Test
    void theLastLibraryIsOpenedAgain() {
        editor.close();
        editor = new EditorGui(folder.resolve("settings"), Scene.EMPTY);
        editor.menu("file-library");
        editor.gui.until("it is there", () -> editor.editor.library().library().path().equals(Optional.of(path.toAbsolutePath())));
    }

    @Test
    void scenesHavePicturesInBothThemesAndLanguages() {
        gui.click(tiles().get(1));
        picturesAreThere();
        assertThat(Screenshots.save(gui, "library-light")).isNotEmptyFile();
        type("#library-filter", "transparancy > 0");
        gui.act(() -> editor.editor.theme().set(Theme.DARK));
        assertThat(Screenshots.save(gui, "library-dark-wrong-filter")).isNotEmptyFile();
        gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
        gui.act(() -> gui.stage().setWidth(1280));
        picturesAreThere();
        assertThat(Screenshots.save(gui, "library-dark-czech")).isNotEmptyFile();
        gui.act(() -> editor.editor.theme().set(Theme.LIGHT));
    }

    @Test
    void whatIsTypedIsFoundAndWhatIsWrongIsTold() {
        type("#library-filter", "tag = \"glass\" and exists(torus) and exists(cone)");
        gui.until("two are found", () -> scenes() == 2);
        assertThat(textNow("#library-count")).isEqualTo("2 of " + all + " scenes");
        type("#library-filter", "transparancy > 0");
        assertThat(textNow("#library-problem")).contains("did you mean \"transparency\"?");
        type("#library-filter", "lighthouse");
        gui.until("one is found", () -> scenes() == 1);
        gui.until("nothing is wrong", () -> text("#library-problem").isEmpty());
    }

    @Test
    void aSceneIsOpenedChangedAndSavedInItsPlace() throws Exception {
        type("#library-filter", "lighthouse");
        gui.until("one is found", () -> scenes() == 1);
        gui.click(tiles().get(0));
        gui.keys(KeyCode.ENTER);
        gui.until("it is in the editor", () -> editor.model().scene().name().equals("Lighthouse"));
        int lights = editor.model().scene().lights().size();
        editor.gui.act(() -> editor.model().edit(cz.paprsek.fx.model.Label.of(cz.paprsek.fx.model.Label.Edit.ADD), scene -> scene.plus(Light.at(9, 9, 9))));
        gui.act(() -> gui.stage().toFront());
        gui.click("#library-add");
        gui.until("the library has it", () -> library.database().get("Lighthouse").lights().size() == lights + 1);
        assertThat(SceneFiles.readDatabase(path).get("Lighthouse")).isEqualTo(editor.model().scene());
        assertThat(editor.gui.stage().getTitle()).isEqualTo("database.xml · Lighthouse – Paprsek");
        assertThat(library.database().size()).isEqualTo(all);
    }

    @Test
    void theCurrentSceneGoesIntoTheLibraryAndStaysThere() throws Exception {
        gui.click("#library-add");
        gui.until("it is there", () -> scenes() == all + 1);
        assertThat(editor.gui.stage().getTitle()).isEqualTo("database.xml · mine – Paprsek");
        gui.until("it is written", () -> !library.unsavedProperty().get());
        assertThat(SceneFiles.readDatabase(path).get("mine")).isEqualTo(editor.model().scene());
    }

    @Test
    void scenesAreRenamedTaggedDoubledAndDeletedByMouseAndKeys() throws Exception {
        gui.click(tiles().get(0));
        gui.keys(KeyCode.F2);
        type("#library-name", "Card");
        type("#library-tags", "one two");
        gui.until("it is another", () -> library.database().find("Card").filter(scene -> scene.tags().equals(List.of("one", "two"))).isPresent());
        gui.click(tiles().get(1));
        gui.keys(KeyCode.CONTROL, KeyCode.D);
        assertThat(library.database().find("Still life 2")).isPresent();
        gui.click(tiles().get(2));
        gui.hold(KeyCode.SHIFT);
        gui.click(tiles().get(4));
        gui.letGo(KeyCode.SHIFT);
        gui.keys(KeyCode.DELETE);
        assertThat(library.database().size()).isEqualTo(all + 1 - 3);
        assertThat(library.database().find("Snowman")).isEmpty();
        gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(library.database().find("Snowman")).isPresent();
        gui.click("#library-undo");
        gui.click("#library-undo");
        gui.click("#library-undo");
        gui.until("all is as it was", () -> library.database().names().contains("Test scene") && !library.unsavedProperty().get());
        assertThat(Files.readString(path)).isEqualTo(Files.readString(Path.of("../scenes/database.xml")));
    }

    @Test
    void everythingIsThereAsATableThatIsSortedAndExported() throws Exception {
        TabPane tabs = (TabPane) gui.node("#library-tabs");
        gui.act(() -> tabs.getSelectionModel().select(1));
        ChoiceBox<?> choice = (ChoiceBox<?>) gui.node("#library-table");
        gui.act(() -> choice.getSelectionModel().select(choice.getItems().stream().map(String::valueOf).toList().indexOf("sphere")));
        type("#library-filter", "radius < 0.4");
        TableView<?> table = (TableView<?>) gui.node("#table");
        gui.until("the rows are there", () -> table.getItems().size() > 10);
        int rows = table.getItems().size();
        Node header = Gui.on(() -> table.lookupAll(".column-header").stream()
                .filter(node -> node.lookupAll(".label").stream().anyMatch(label -> ((Labeled) label).getText().equals("Radius"))).findFirst().orElseThrow());
        gui.click(header);
        picturesOfTables();
        editor.dialogs.save = Optional.of(folder.resolve("table.csv"));
        gui.click("#library-export");
        gui.until("it is written", () -> text("#library-message").startsWith("Saved"));
        List<String> lines = Files.readAllLines(folder.resolve("table.csv"));
        assertThat(lines).hasSize(rows + 1).first().asString().startsWith("scene,path,name,depth,radius");
        List<Double> radii = lines.stream().skip(1).map(line -> Double.valueOf(line.split(",", -1)[4])).toList();
        assertThat(radii).isSorted();
        editor.dialogs.save = Optional.of(folder.resolve("table.json"));
        gui.click("#library-export");
        gui.until("it is written", () -> text("#library-message").endsWith("json"));
        assertThat(Files.readAllLines(folder.resolve("table.json"))).hasSize(rows).first().asString().startsWith("{\"scene\":");
    }

    @Test
    void withoutADatabaseTablesSayThatThereIsNone() {
        try (EditorGui fresh = new EditorGui(folder.resolve("none"), Scene.EMPTY)) {
            fresh.menu("file-library");
            fresh.gui.until("the library is there", () -> fresh.editor.library().stage().isPresent());
            javafx.scene.Parent root = Gui.on(() -> fresh.editor.library().stage().orElseThrow().getScene().getRoot());
            fresh.gui.act(() -> ((TabPane) root.lookup("#library-tabs")).getSelectionModel().select(1));
            fresh.gui.until("it is said", () -> root.lookup("#table") instanceof TableView<?> table && table.getPlaceholder() instanceof Labeled why && why.getText().startsWith("No database is open."));
        }
    }

    /** Words of filters and files are those of files; what is shown is the window's. */
    @Test
    void tablesSpeakTheLanguageOfTheWindow() {
        gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
        gui.act(() -> ((TabPane) gui.node("#library-tabs")).getSelectionModel().select(1));
        type("#library-filter", "kind = \"sphere\" and position.y = 0.8");
        TableView<?> table = (TableView<?>) gui.node("#table");
        gui.until("the rows are there", () -> !table.getItems().isEmpty() && table.getItems().size() < 1000);
        List<String> shown = Gui.on(() -> Stream.of(".label", ".table-cell").flatMap(style -> table.lookupAll(style).stream()).filter(Labeled.class::isInstance).map(node -> ((Labeled) node).getText()).toList());
        assertThat(Gui.on(() -> table.getColumns().stream().map(TableColumn::getText).toList())).as("read aloud").contains("Poloha", "Druh");
        assertThat(shown).contains("Poloha", "Druh", "koule", "-3,1 0,8 -0,4").doesNotContain("kind", "Position", "sphere", "-3.1 0.8 -0.4");
        assertThat(Gui.on(() -> ((ChoiceBox<?>) gui.node("#library-table")).lookup(".label"))).isInstanceOfSatisfying(Labeled.class, label -> assertThat(label.getText()).isEqualTo("Objekty a operandy"));
        int rows = Gui.on(() -> table.getItems().size());
        type("#library-filter", "KOULE glass");
        gui.until("what is shown is found", () -> !table.getItems().isEmpty() && table.getItems().size() != rows);
        int found = Gui.on(() -> table.getItems().size());
        type("#library-filter", "");
        gui.until("all is there again", () -> table.getItems().size() > found);
        type("#library-filter", "sphere glass");
        gui.until("and so is what files call it", () -> table.getItems().size() == found);
        type("#library-filter", "positio > 1");
        assertThat(textNow("#library-problem")).startsWith("znak 1: ").contains("nemyslíte \"position\"?").doesNotContain("there");
    }

    private void picturesOfTables() {
        assertThat(Screenshots.save(gui, "library-table")).isNotEmptyFile();
    }

    @Test
    void whatOthersWriteIsShownAndAClashIsToldBeforeItIsLeft() throws Exception {
        DatabaseFile.update(path, database -> database.without(List.of("Snowman")));
        gui.act(editor.editor.library()::checkDisk);
        gui.until("it is gone", () -> scenes() == all - 1);
        DatabaseFile.update(path, database -> database.replace("Planets", database.get("Planets").withDescription("theirs")));
        gui.act(() -> library.tag(List.of("Planets"), "mine"));
        gui.until("it is refused", () -> text("#library-refusal").contains("\"Planets\""));
        assertThat(Screenshots.save(gui, "library-refused")).isNotEmptyFile();
        editor.dialogs.unsaved = Dialogs.Unsaved.STAY;
        assertThat(Gui.on(() -> editor.editor.library().mayLeave())).isFalse();
        gui.click("#library-reload");
        gui.until("theirs is shown", () -> library.database().get("Planets").description().equals("theirs"));
        assertThat(Gui.on(() -> editor.editor.library().mayLeave())).isTrue();
    }

    @Test
    void aDatabaseThatIsOpenedShowsAllItsScenes() {
        try (EditorGui fresh = new EditorGui(folder.resolve("other"), Scene.EMPTY)) {
            fresh.gui.act(() -> fresh.editor.files().open(path));
            fresh.gui.until("the first scene is there", () -> fresh.model().scene().name().equals("Test scene"));
            fresh.gui.until("and the library", () -> fresh.editor.library().stage().isPresent());
            assertThat(Gui.on(() -> fresh.editor.library().library().database().size())).isEqualTo(all);
        }
    }

    @Test
    void aSceneIsAddedToTheCurrentOne() {
        gui.click(tiles().get(1));
        gui.click("#library-insert");
        Scene both = editor.model().scene();
        assertThat(both.name()).isEqualTo("mine");
        assertThat(both.objects()).hasSameSizeAs(library.database().get("Still life").objects());
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        gui.act(() -> editor.model().undo());
        assertThat(editor.model().scene().objects()).isEmpty();
    }
}
