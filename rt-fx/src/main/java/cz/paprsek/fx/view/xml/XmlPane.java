package cz.paprsek.fx.view.xml;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.typing.Change;
import cz.paprsek.fx.model.typing.Manuscript;
import cz.paprsek.fx.model.typing.Page;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.xml.Problem;
import cz.paprsek.xml.typing.Completion;
import cz.paprsek.xml.typing.Completion.Proposal;
import java.util.List;
import java.util.Optional;
import javafx.animation.PauseTransition;
import javafx.application.Platform;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.WeakChangeListener;
import javafx.geometry.Point2D;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Label;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.util.Duration;
import org.fxmisc.flowless.VirtualizedScrollPane;
import org.fxmisc.richtext.CodeArea;
import org.fxmisc.richtext.LineNumberFactory;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;

/** The text of the scene, to be read and written in. What is not valid yet is underlined, and told below. */
public final class XmlPane extends BorderPane {
    /** How long nobody types until what was typed is looked at. */
    private static final Duration REST = Duration.millis(600);
    private static final Duration PAINT = Duration.millis(40);
    /** Long texts are painted later, so that typing goes on. */
    private static final double LETTERS_PER_MILLI = 2500;

    private final Manuscript manuscript;
    private final EditorModel model;
    private final Texts texts;
    private final CodeArea area = new CodeArea();
    private final StackPane over = new StackPane();
    private final ProposalList proposals;
    private final Label told = new Label();
    private final Button giveUp = new Button();
    private final HBox strip = new HBox(told, giveUp);
    private final PauseTransition rest = new PauseTransition(REST);
    private final PauseTransition paint = new PauseTransition(PAINT);
    /** Held here, because the model, which outlives the window, holds them weakly. */
    private final ChangeListener<Page> onPage = (property, old, now) -> show(now);
    private final ChangeListener<Object> onSelection = (property, old, now) -> showSelection();
    private final ChangeListener<Object> onPoint = (property, old, now) -> Platform.runLater(this::goToMistake);
    private Completion offered = new Completion(0, 0, "", List.of());
    private boolean isShowing;
    private boolean hasSeenSelection;

    public XmlPane(Manuscript manuscript, EditorModel model, Texts texts) {
        this.manuscript = manuscript;
        this.model = model;
        this.texts = texts;
        setId("xml-pane");
        getStylesheets().add(String.valueOf(XmlPane.class.getResource("xml.css")));
        area.setId("xml-text");
        area.setParagraphGraphicFactory(LineNumberFactory.get(area));
        area.setWrapText(true);
        area.setAccessibleText(texts.of("xml.title"));
        proposals = new ProposalList(texts, this::take);
        over.getChildren().addAll(new VirtualizedScrollPane<>(area), proposals);
        setMinWidth(200);
        setTop(head());
        setCenter(over);
        told.setId("xml-told");
        told.setWrapText(true);
        told.setMaxWidth(Double.MAX_VALUE);
        told.setMinHeight(Region.USE_PREF_SIZE);
        HBox.setHgrow(told, Priority.ALWAYS);
        told.setOnMouseClicked(event -> goToMistake(1));
        giveUp.setId("xml-give-up");
        giveUp.setText(texts.of("xml.give-up"));
        giveUp.setMinWidth(Region.USE_PREF_SIZE);
        giveUp.setOnAction(event -> {
            manuscript.giveUp();
            area.requestFocus();
        });
        strip.setAlignment(Pos.CENTER_LEFT);
        strip.getStyleClass().add("xml-strip");
        setBottom(strip);
        rest.setOnFinished(event -> manuscript.check());
        paint.setOnFinished(event -> paint());
        area.textProperty().addListener((property, old, now) -> typed(now));
        area.caretPositionProperty().addListener((property, old, now) -> {
            if (proposals.isVisible()) {
                offer();
            }
        });
        area.addEventFilter(KeyEvent.KEY_PRESSED, this::pressed);
        area.addEventHandler(KeyEvent.KEY_PRESSED, XmlPane::keep);
        area.addEventHandler(MouseEvent.MOUSE_CLICKED, this::clicked);
        area.setContextMenu(contextMenu());
        area.focusedProperty().addListener((property, old, now) -> {
            if (!now) {
                proposals.hide();
            }
        });
        area.editableProperty().bind(manuscript.writableProperty());
        manuscript.pageProperty().addListener(new WeakChangeListener<>(onPage));
        manuscript.pointsProperty().addListener(new WeakChangeListener<>(onPoint));
        model.selectionProperty().addListener(new WeakChangeListener<>(onSelection));
        show(manuscript.page());
    }

    private HBox head() {
        Label caption = new Label(texts.of("xml.title"));
        caption.getStyleClass().add("view-caption");
        caption.setMinWidth(Region.USE_PREF_SIZE);
        ShortLabel hint = new ShortLabel(texts.of("xml.hint"), texts.of("xml.hint.short"));
        hint.getStyleClass().add("xml-hint");
        HBox.setHgrow(hint, Priority.ALWAYS);
        Button close = new Button("", new FontIcon(MaterialDesignC.CLOSE));
        close.setId("xml-close");
        close.getStyleClass().add("view-button");
        close.setFocusTraversable(false);
        Hint.of(close).set(texts.of("xml.close"));
        close.setAccessibleText(texts.of("xml.close"));
        close.setOnAction(event -> manuscript.openProperty().set(false));
        HBox head = new HBox(caption, hint, close);
        head.setAlignment(Pos.CENTER_LEFT);
        head.getStyleClass().add("view-title");
        return head;
    }

    private ContextMenu contextMenu() {
        return new ContextMenu(item("edit-menu.cut", area::cut), item("edit-menu.copy", area::copy), item("edit-menu.paste", area::paste), item("edit-menu.select-all", area::selectAll),
                new SeparatorMenuItem(), item("xml.propose", this::offer));
    }

    private MenuItem item(String key, Runnable action) {
        MenuItem item = new MenuItem(texts.of(key));
        item.setId("xml-" + key.substring(key.indexOf('.') + 1));
        item.setOnAction(event -> {
            area.requestFocus();
            action.run();
        });
        return item;
    }

    /** Gives the keyboard to the text. */
    public void takeKeys() {
        area.requestFocus();
    }

    /** Undoes what was typed and is not in the scene yet; false if there is nothing of that, or the keyboard is elsewhere. */
    public boolean undo() {
        boolean is = area.isFocused() && manuscript.page().isHeld() && area.isUndoAvailable();
        if (is) {
            area.undo();
        }
        return is;
    }

    /** Does again what {@link #undo} has undone. */
    public boolean redo() {
        boolean is = area.isFocused() && area.isRedoAvailable();
        if (is) {
            area.redo();
        }
        return is;
    }

    /** Goes to the first mistake, and gives the keyboard to the text. */
    private void goToMistake() {
        area.requestFocus();
        area.moveTo(0);
        goToMistake(1);
    }

    private void typed(String now) {
        if (!isShowing) {
            manuscript.write(now);
            rest.playFromStart();
        }
        paint.playFromStart();
    }

    /** Replaces what is no longer the same: caret and scroll stay where they are. */
    private void show(Page page) {
        String shown = area.getText();
        Change change = Change.between(shown, page.text());
        if (!change.isNone()) {
            paint.setDuration(PAINT.add(Duration.millis(page.text().length() / LETTERS_PER_MILLI)));
            int caret = area.getCaretPosition();
            proposals.hide();
            isShowing = true;
            area.replaceText(change.from(), change.to(), change.text());
            isShowing = false;
            area.moveTo(shown.isEmpty() ? 0 : change.after(caret).orElse(change.from()));
            if (shown.isEmpty()) {
                hasSeenSelection = false;
            }
        }
        if (!page.isHeld()) {
            area.getUndoManager().forgetHistory();
        }
        tell(page);
        paint.playFromStart();
    }

    private void tell(Page page) {
        boolean isSaid = !page.problems().isEmpty() || page.isCrossed();
        giveUp.setVisible(page.isHeld());
        giveUp.setManaged(page.isHeld());
        strip.setVisible(isSaid);
        strip.setManaged(isSaid);
        String crossed = page.isCrossed() ? texts.of("xml.crossed") : "";
        String wrong = page.problems().stream().findFirst().map(this::sentence).orElse("");
        String more = page.problems().size() > 1 ? texts.of("xml.more", page.problems().size() - 1) : "";
        told.setText(String.join(" ", List.of(crossed, wrong, more)).strip());
    }

    private String sentence(Problem problem) {
        if (!manuscript.page().isHeld()) {
            return texts.sentence(problem.message());
        }
        String place = (problem.file().equals(XmlStyles.OWN) ? "" : problem.file() + ":") + problem.line() + ":" + problem.column();
        return place + "  " + texts.sentence(problem.message());
    }

    private void paint() {
        Page page = manuscript.page();
        if (!page.text().isEmpty() && area.getLength() == page.text().length()) {
            area.setStyleSpans(0, XmlStyles.of(page, model.selection()));
            if (!hasSeenSelection && !page.stands().isEmpty()) {
                hasSeenSelection = true;
                showSelection();
            }
        }
    }

    /** What is selected elsewhere is shown; who writes here stays where he is. */
    private void showSelection() {
        paint.playFromStart();
        if (!area.isFocused()) {
            model.selection().stream().reduce((first, second) -> second).flatMap(place -> manuscript.page().of(place)).ifPresent(stand -> {
                area.moveTo(Math.min(stand.from(), area.getLength()));
                area.showParagraphAtCenter(area.getCurrentParagraph());
            });
        }
    }

    private void clicked(MouseEvent event) {
        if (event.getButton() == MouseButton.PRIMARY && event.isStillSincePress() && area.getSelection().getLength() == 0) {
            Optional<ScenePath> place = manuscript.page().at(area.getCaretPosition());
            // Named materials stand in the sheet where nothing is selected.
            model.select(place.filter(one -> !(one instanceof ScenePath.MaterialAt)).stream().toArray(ScenePath[]::new));
        }
    }

    private void pressed(KeyEvent event) {
        if (proposals.uses(event)) {
            event.consume();
        } else if (event.getCode() == KeyCode.SPACE && event.isControlDown()) {
            offer();
            event.consume();
        } else if (event.getCode() == KeyCode.F8) {
            goToMistake(event.isShiftDown() ? -1 : 1);
            event.consume();
        } else if (event.getCode() == KeyCode.ENTER && !event.isShortcutDown()) {
            breakLine();
            event.consume();
        } else if (event.getCode() == KeyCode.TAB) {
            // The keyboard goes on; blanks are typed.
            event.consume();
            if (!event.isShiftDown() && strip.isVisible()) {
                giveUp.requestFocus();
            }
        }
    }

    /** What is typed is meant for nothing else. */
    private static void keep(KeyEvent event) {
        if (!event.isShortcutDown() && !event.isAltDown() && !event.isControlDown() && !event.getCode().isFunctionKey()) {
            event.consume();
        }
    }

    /** A new line begins below the last one. */
    private void breakLine() {
        String line = area.getParagraph(area.getCurrentParagraph()).getText();
        int blanks = 0;
        while (blanks < Math.min(line.length(), area.getCaretColumn()) && Character.isWhitespace(line.charAt(blanks))) {
            blanks++;
        }
        area.replaceSelection("\n" + line.substring(0, blanks));
        area.requestFollowCaret();
    }

    private void goToMistake(int step) {
        int caret = area.getCaretPosition();
        List<Integer> places = manuscript.page().problems().stream().flatMap(problem -> XmlStyles.piece(area.getText(), problem).stream()).map(XmlStyles.Piece::from).sorted().toList();
        Optional<Integer> next = step > 0 ? places.stream().filter(place -> place > caret).findFirst().or(() -> places.stream().findFirst())
                : places.stream().filter(place -> place < caret).reduce((first, second) -> second).or(() -> places.stream().reduce((first, second) -> second));
        next.ifPresent(place -> {
            area.moveTo(place);
            area.requestFollowCaret();
            area.requestFocus();
        });
    }

    private void offer() {
        offered = Completion.at(area.getText(), area.getCaretPosition(), Naming.of(manuscript.scene(), area.getText()));
        area.getCaretBounds().map(bounds -> over.screenToLocal(bounds)).ifPresentOrElse(caret -> {
            Point2D below = new Point2D(caret.getMinX(), caret.getMaxY() + 2);
            proposals.show(offered, below.getX(), below.getY(), caret.getHeight() + 4);
        }, proposals::hide);
    }

    private void take(Proposal one) {
        area.replaceText(offered.from(), offered.to(), one.text());
        area.moveTo(offered.from() + one.caret());
        area.requestFollowCaret();
        area.requestFocus();
        // Behind the name of an attribute comes its value.
        if (one.kind() == Completion.Kind.ATTRIBUTE) {
            Platform.runLater(this::offer);
        }
    }
}
