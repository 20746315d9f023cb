package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.view.manual.ManualPane;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.lesson.Lesson;
import cz.paprsek.lesson.Lessons;
import cz.paprsek.lesson.Question;
import cz.paprsek.lesson.Task;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Labeled;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

/** Lessons in the whole window, and what else a newcomer meets: where to begin, the tour, the manual. */
class LessonsInEditorTest {
    @TempDir
    Path folder;

    private EditorGui editor;
    private final Lesson sphere = Lessons.shipped("sphere");

    @BeforeEach
    void open() {
        editor = new EditorGui(folder, Scene.EMPTY, 1024, 768);
    }

    @AfterEach
    void close() {
        editor.close();
    }

    /** The number of the lesson's first part of that kind. */
    private int part(Class<?> kind) {
        return IntStream.range(0, sphere.parts().size()).filter(i -> kind.isInstance(sphere.parts().get(i))).findFirst().orElseThrow();
    }

    private String text(String id) {
        return Gui.on(() -> {
            Node node = editor.gui.stage().getScene().lookup(id);
            return node == null ? "" : ((Labeled) node).getText();
        });
    }

    private void answer(int part, String typed) {
        editor.gui.act(() -> {
            TextField field = (TextField) editor.gui.stage().getScene().lookup("#lesson-answer-" + part);
            field.requestFocus();
            field.setText(typed);
        });
        editor.gui.keys(KeyCode.ENTER);
    }

    private int question() {
        return part(Question.class);
    }

    private int task() {
        return part(Task.class);
    }

    @Test
    void aQuestionIsMarkedAndATaskIsDoneInTheScene() {
        editor.menu("lesson-sphere");
        assertThat(editor.model().scene()).isEqualTo(sphere.scene());
        assertThat(text("#lesson-title")).isEqualTo("2. Where a ray meets a ball");
        assertThat(text("#lesson-progress")).isEqualTo("0 of 3 done");
        String verdict = "#lesson-verdict-" + question();
        answer(question(), "5.8");
        editor.gui.until("the wrong answer is told what it is", () -> text(verdict).startsWith("Not yet. That is where the ray comes out"));
        answer(question(), "about four");
        editor.gui.until("that is no number", () -> text(verdict).startsWith("Write one number"));
        answer(question(), "5 - 0,8");
        editor.gui.until("the right answer is taken", () -> text(verdict).startsWith("Right. "));
        assertThat(text("#lesson-progress")).isEqualTo("1 of 3 done");
        String done = "#lesson-verdict-" + task();
        editor.gui.until("the task is open", () -> text(done).startsWith("Not done yet."));
        Scene solved = sphere.tasks().get(0).solution();
        editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.RESIZE), scene -> scene.withObjects(solved.objects())));
        editor.gui.until("the task is done", () -> text(done).startsWith("Done. "));
        assertThat(text("#lesson-progress")).isEqualTo("2 of 3 done");
    }

    /** The next lesson does not ask what is to become of the exercise; what has been answered is there again. */
    @Test
    void progressIsKeptFromLessonToLessonAndInTheOtherLanguage() {
        editor.menu("lesson-sphere");
        answer(question(), "4.2");
        editor.gui.until("the right answer is taken", () -> text("#lesson-progress").equals("1 of 3 done"));
        editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.RENAME), scene -> scene.withName("mine")));
        editor.gui.click("#lesson-next");
        assertThat(text("#lesson-title")).isEqualTo("3. Plane and block");
        assertThat(editor.dialogs.asked).isEmpty();
        editor.gui.click("#lesson-previous");
        editor.gui.until("what was answered is marked again", () -> text("#lesson-verdict-" + question()).startsWith("Right."));
        editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
        editor.gui.until("it is told in Czech", () -> text("#lesson-verdict-" + question()).startsWith("Správně."));
        assertThat(text("#lesson-title")).isEqualTo("2. Kde paprsek potká kouli");
        editor.gui.click("#lesson-close");
        assertThat(Gui.on(() -> Optional.ofNullable(editor.gui.stage().getScene().lookup("#lesson-pane")))).isEmpty();
        editor.menu("teach-lessons");
        assertThat(text("#lesson-progress")).isEqualTo("Hotovo 1 z 3");
    }

    /** A lesson that has been left does not look at the scene of the next one. */
    @Test
    void theTaskOfTheNextLessonIsDoneWithoutTheOneBefore() {
        List<Throwable> faults = new CopyOnWriteArrayList<>();
        editor.gui.act(() -> Thread.currentThread().setUncaughtExceptionHandler((thread, fault) -> faults.add(fault)));
        editor.menu("lesson-phong");
        editor.menu("lesson-sphere");
        Scene solved = sphere.tasks().get(0).solution();
        editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.RESIZE), scene -> scene.withObjects(solved.objects())));
        editor.gui.until("the task is done", () -> text("#lesson-progress").equals("1 of 3 done"));
        assertThat(faults).isEmpty();
        editor.gui.act(() -> Thread.currentThread().setUncaughtExceptionHandler(null));
    }

    @Test
    void aPixelIsExplainedBesideTheLesson() {
        editor.menu("lesson-sphere");
        editor.gui.until("the picture is complete", editor.editor::isPictureComplete);
        int look = part(Lesson.Look.class);
        editor.gui.act(() -> ((Button) editor.gui.stage().getScene().lookup("#lesson-look-" + look)).fire());
        editor.gui.until("the pixel is explained", () -> text("#explain-title").equals("Pixel 85, 50"));
        assertThat(Gui.on(() -> Optional.ofNullable(editor.gui.stage().getScene().lookup("#lesson-pane")))).isPresent();
        editor.gui.click("#lesson-next");
        assertThat(Gui.on(() -> Optional.ofNullable(editor.gui.stage().getScene().lookup("#explain-title")))).as("the next lesson asks first").isEmpty();
    }

    /** In a narrow window a lesson stands in the place of palette and tree; all four columns are in a wide one. */
    @Test
    void viewsAndSheetStayBesideALesson() {
        editor.menu("lesson-sphere");
        for (String part : new String[] {"#lesson-pane", "#pane-grid", "#property-sheet"}) {
            assertThat(Gui.on(() -> editor.gui.stage().getScene().lookup(part).getLayoutBounds().getWidth())).as(part).isGreaterThan(259);
        }
        assertThat(Gui.on(() -> Optional.ofNullable(editor.gui.stage().getScene().lookup("#tree-list")))).isEmpty();
        editor.gui.act(() -> editor.gui.stage().setWidth(1400));
        assertThat(Gui.on(() -> Optional.ofNullable(editor.gui.stage().getScene().lookup("#tree-list")))).isPresent();
    }

    @Test
    void alessonOfOnesOwnIsOpenedAndWhatIsWrongWithOneIsSaid() throws IOException {
        Files.writeString(folder.resolve("scene.xml"), "<scene xmlns=\"urn:paprsek:scene:1\"><render width=\"8\" height=\"8\"/><camera position=\"0 0 5\" target=\"0 0 0\"/></scene>");
        Path file = Files.writeString(folder.resolve("mine.xml"), "<lesson xmlns=\"urn:paprsek:lesson:1\" scene=\"scene.xml\"><title><en>Mine</en><cs>Moje</cs></title></lesson>");
        editor.dialogs.open = Optional.of(file);
        editor.menu("teach-open");
        editor.gui.until("the lesson is open", () -> text("#lesson-title").equals("Mine"));
        editor.menu("lesson-sphere");
        assertThat(text("#lesson-title")).isNotEqualTo("Mine");
        Path told = Files.writeString(folder.resolve("told.xml"), "<?xml version='1.0'?>\n<!-- <scene> -->\n" + Files.readString(file));
        editor.gui.act(() -> editor.editor.files().open(told));
        editor.gui.until("so it is as any other file", () -> text("#lesson-title").equals("Mine"));
        Files.writeString(file, "<lesson xmlns=\"urn:paprsek:lesson:1\" scene=\"../scene.xml\"><title><en>Mine</en><cs>Moje</cs></title></lesson>");
        editor.menu("teach-open");
        editor.gui.until("the problem is listed", () -> editor.gui.stage().getScene().getRoot().lookupAll(".list-cell").stream()
                .anyMatch(cell -> String.valueOf(((Labeled) cell).getText()).contains(".. leads out")));
    }

    static final List<Locale> LANGUAGES = Texts.LANGUAGES;

    /** Menus are made without reading ten files. */
    @ParameterizedTest
    @FieldSource("LANGUAGES")
    void lessonsAreCalledTheSameInTheMenuAsInTheirFiles(Locale language) {
        for (String name : Lessons.NAMES) {
            assertThat(Texts.in(language).of("lesson." + name)).isEqualTo(Lessons.shipped(name).title().in(language));
        }
    }

    /** Closing a lesson and coming back to it does not begin its scene anew; what was made after closing is asked about. */
    @Test
    void whatHasBecomeOfTheSceneIsNotLostWithTheLesson() {
        editor.menu("lesson-sphere");
        editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.RENAME), scene -> scene.withName("mine")));
        editor.menu("teach-lessons");
        editor.menu("teach-lessons");
        assertThat(text("#lesson-title")).isEqualTo("2. Where a ray meets a ball");
        assertThat(editor.model().scene().name()).isEqualTo("mine");
        assertThat(editor.model().undoableProperty().get()).isPresent();
        editor.gui.click("#lesson-close");
        editor.menu("lesson-shadows");
        assertThat(editor.dialogs.asked).singleElement().asString().startsWith("unsaved");
        assertThat(editor.model().scene().name()).as("one stays").isEqualTo("mine");
    }

    @Test
    void lessonsOfOneNameAreNotTheSameAndTheLastOneIsGoneOnWith() throws IOException {
        Files.writeString(folder.resolve("scene.xml"), "<scene xmlns=\"urn:paprsek:scene:1\"><render width=\"8\" height=\"8\"/><camera position=\"0 0 5\" target=\"0 0 0\"/></scene>");
        String said = "<en>a</en><cs>b</cs>";
        Path file = Files.writeString(folder.resolve("sphere.xml"), "<lesson xmlns=\"urn:paprsek:lesson:1\" scene=\"scene.xml\"><title><en>Mine</en><cs>Moje</cs></title>"
                + "<question answer=\"4\" tolerance=\"0.1\">" + said + "<hint>" + said + "</hint><why>" + said + "</why></question></lesson>");
        editor.menu("lesson-sphere");
        answer(question(), "4.2");
        editor.gui.until("the right answer is taken", () -> text("#lesson-progress").equals("1 of 3 done"));
        editor.dialogs.open = Optional.of(file);
        editor.menu("teach-open");
        editor.gui.until("the lesson is open", () -> text("#lesson-title").equals("Mine"));
        assertThat(text("#lesson-progress")).isEqualTo("0 of 1 done");
        editor.menu("teach-lessons");
        editor.menu("teach-lessons");
        assertThat(text("#lesson-title")).isEqualTo("Mine");
    }

    private Node node(String id) {
        return editor.gui.stage().getScene().lookup(id);
    }

    private boolean isWelcome() {
        return Gui.on(() -> node("#welcome").isVisible());
    }

    @Test
    void shippedScenesArePicturesThatAreOpenedByKeys() {
        editor.menu("help-menu-welcome");
        assertThat(isWelcome()).isTrue();
        editor.gui.until("the first picture is there", () -> node("#welcome-shipped").lookup(".welcome-picture").lookup(".image-view") instanceof ImageView view && view.getImage() != null);
        editor.gui.keys(KeyCode.ESCAPE);
        assertThat(isWelcome()).isFalse();
        editor.menu("help-menu-welcome");
        // The tour, three new ones, open, library, manual, at the start; then the tiles.
        for (int i = 0; i < 8; i++) {
            editor.gui.keys(KeyCode.TAB);
        }
        assertThat(Gui.on(() -> editor.gui.stage().getScene().getFocusOwner() instanceof Button button ? button.getText() : "")).isEqualTo(Templates.EXAMPLES.get(0));
        editor.gui.keys(KeyCode.SPACE);
        editor.gui.until("the scene is open", () -> editor.model().scene().equals(Templates.read(Templates.EXAMPLES.get(0))));
        assertThat(isWelcome()).isFalse();
    }

    @Test
    void whetherItComesAtTheStartIsRemembered() {
        assertThat(Welcome.isWanted(editor.editor.settings())).isTrue();
        editor.menu("help-menu-welcome");
        editor.gui.click("#welcome-at-start");
        assertThat(Welcome.isWanted(editor.editor.settings())).isFalse();
        editor.gui.click("#welcome-new-studio");
        assertThat(isWelcome()).isFalse();
        assertThat(editor.model().scene()).isEqualTo(Templates.read("studio"));
    }

    @Test
    void whatIsOpenedByKeysIsNotHiddenByTheWelcome() {
        editor.menu("help-menu-welcome");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.N);
        editor.gui.until("it gives way", () -> !isWelcome());
        assertThat(editor.model().scene()).isEqualTo(Templates.read("plain"));
    }

    @Test
    void theTourIsDoneStepByStepAndCountsWhatIsDone() {
        editor.menu("help-menu-tour");
        Lesson tour = Lessons.tour();
        assertThat(text("#lesson-title")).isEqualTo("A bowl with handles in five minutes");
        int done = 0;
        for (Task task : tour.tasks()) {
            editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.CHANGE), scene -> task.solution()));
            done++;
            String counted = done + " of 10 done";
            editor.gui.until(counted, () -> text("#lesson-progress").equals(counted));
            String next = "#lesson-help-" + Math.min(tour.parts().indexOf(task) + 1, tour.parts().indexOf(tour.tasks().get(9)));
            editor.gui.until("the next task is in sight", () -> isInSight(editor.gui.stage().getScene().lookup(next)));
        }
        editor.gui.click("#lesson-begin-" + tour.parts().indexOf(tour.tasks().get(9)));
        assertThat(editor.dialogs.asked).as("what has been built is not given up unasked").singleElement().asString().startsWith("unsaved");
        editor.menu("edit-menu-undo");
        assertThat(text("#lesson-progress")).isEqualTo("10 of 10 done");
    }

    /** Who leafs through the lessons clicks at one place. */
    @Test
    void theButtonsStayWhereTheyAreWhateverALessonIsCalled() {
        editor.menu("lesson-plane-and-block");
        double y = top("#lesson-next");
        double height = Gui.on(() -> editor.gui.stage().getScene().lookup("#lesson-title").getLayoutBounds().getHeight());
        editor.gui.click("#lesson-next");
        editor.gui.until("a title of two lines", () -> editor.gui.stage().getScene().lookup("#lesson-title").getLayoutBounds().getHeight() > 1.5 * height);
        assertThat(top("#lesson-next")).isEqualTo(y);
    }

    private double top(String id) {
        return Gui.on(() -> {
            Node node = editor.gui.stage().getScene().lookup(id);
            return node.localToScene(node.getLayoutBounds()).getMinY();
        });
    }

    /** The tour asks for what is selected in the tree, in whose place it stands in a narrow window. */
    @Test
    void theTourTellsHowToReachTheTreeInANarrowWindow() {
        editor.menu("help-menu-tour");
        Lesson tour = Lessons.tour();
        editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.CHANGE), scene -> tour.tasks().get(0).solution()));
        editor.gui.until("the ball is counted", () -> text("#lesson-progress").equals("1 of 10 done"));
        assertThat(Gui.on(() -> editor.gui.stage().getScene().getRoot().lookupAll("#lesson-pane .label").stream().map(label -> ((Labeled) label).getText())
                .filter(said -> said.contains("narrow window")).findFirst())).hasValueSatisfying(said -> assertThat(said).contains("Ctrl+T takes it away, and brings it back"));
        editor.gui.keys(KeyCode.CONTROL, KeyCode.T);
        assertThat(Gui.on(() -> Optional.ofNullable(editor.gui.stage().getScene().lookup("#tree-list")))).isPresent();
        editor.gui.keys(KeyCode.CONTROL, KeyCode.T);
        assertThat(text("#lesson-progress")).isEqualTo("1 of 10 done");
    }

    private boolean isInSight(Node node) {
        Node pane = editor.gui.stage().getScene().lookup("#lesson-scroll");
        return pane.localToScene(pane.getLayoutBounds()).contains(node.localToScene(node.getLayoutBounds()));
    }

    @Test
    void theManualIsSearchedAndFollowedAndSpeaksBothLanguages() {
        editor.menu("help-menu-manual");
        ManualPane pane = pane();
        assertThat(Gui.on(pane::path)).isEqualTo("README.md");
        editor.gui.act(() -> ((TextField) pane.lookup("#manual-search")).setText("rubber band"));
        assertThat(Gui.on(pane::path)).isEqualTo("docs/editor.md");
        assertThat(Gui.on(() -> ((ListView<?>) pane.lookup("#manual-pages")).getItems().size())).isBetween(1, 4);
        assertThat(Gui.on(() -> pane.lookup(".manual-found"))).isNotNull();
        editor.gui.act(() -> pane.show("docs/lessons.md"));
        assertThat(Gui.on(pane::path)).isEqualTo("docs/lessons.md");
        editor.gui.act(() -> ((Button) pane.lookup("#manual-back")).fire());
        assertThat(Gui.on(pane::path)).isEqualTo("docs/editor.md");
        editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
        assertThat(Gui.on(() -> pane().path())).as("the same page").isEqualTo("docs/cs/editor.md");
    }

    /** Decisions are too many for the list, and are found by a link or a word. */
    @Test
    void theManualOpensADecisionByItsLinkAndByItsWords() {
        editor.menu("help-menu-manual");
        ManualPane pane = pane();
        ListView<?> names = (ListView<?>) pane.lookup("#manual-pages");
        int listed = Gui.on(() -> names.getItems().size());
        assertThat(listed).isLessThan(40);
        editor.gui.act(() -> pane.show("docs/decisions.md"));
        editor.gui.act(() -> link(pane, "Objects have no id").fire());
        assertThat(Gui.on(pane::path)).isEqualTo("docs/decisions/objects-have-no-id.md");
        assertThat(Gui.on(() -> names.getSelectionModel().isEmpty())).as("no other name is marked").isTrue();
        editor.gui.act(() -> ((Button) pane.lookup("#manual-back")).fire());
        assertThat(Gui.on(pane::path)).isEqualTo("docs/decisions.md");
        TextField search = (TextField) pane.lookup("#manual-search");
        editor.gui.act(() -> search.setText("JSqlParser overflow"));
        String found = "docs/decisions/the-filter-language-is-our-own.md";
        assertThat(Gui.on(pane::path)).isEqualTo(found);
        editor.gui.act(search::clear);
        assertThat(Gui.on(pane::path)).as("whoever has found it reads on").isEqualTo(found);
        assertThat(Gui.on(() -> names.getItems().size())).isEqualTo(listed);
    }

    private static Hyperlink link(ManualPane pane, String text) {
        return pane.lookupAll(".hyperlink").stream().filter(Hyperlink.class::isInstance).map(Hyperlink.class::cast).filter(link -> link.getText().equals(text)).findFirst().orElseThrow();
    }

    private ManualPane pane() {
        return Gui.on(() -> (ManualPane) editor.editor.manual().stage().map(stage -> stage.getScene().getRoot()).orElseThrow());
    }

    @Test
    void theTourSpeaksCzech() {
        editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
        editor.menu("help-menu-tour");
        assertThat(text("#lesson-title")).isEqualTo("Mísa s uchy za pět minut");
        assertThat(Gui.on(() -> Optional.ofNullable(node("#lesson-next")).map(Node::isDisabled))).contains(true);
    }
}
