package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.model.property.Section;
import cz.paprsek.fx.model.property.Sections;
import cz.paprsek.fx.view.command.Command;
import cz.paprsek.fx.view.command.FileFinder;
import cz.paprsek.fx.view.command.UndoKeys;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.fx.view.texts.Titles;
import cz.paprsek.scene.Scene;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import javafx.animation.Animation;
import javafx.animation.PauseTransition;
import javafx.application.Platform;
import javafx.beans.InvalidationListener;
import javafx.beans.WeakInvalidationListener;
import javafx.beans.property.BooleanProperty;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.TitledPane;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.VBox;
import javafx.util.Duration;

/**
 * Shows and changes everything about what is selected, or about the scene if nothing is. Made from the components of the records, so that a
 * new kind of shape needs no more than the labels of its components.
 */
public final class PropertySheet extends BorderPane {
    /** How long numbers that are dragged stay to be read. */
    private static final double READ_MILLIS = 80;
    /** Of the time of a drag, following takes one part of so many at most. */
    private static final int PART = 8;

    private final EditorModel model;
    private final Editors editors;
    private final Titles titles;
    private final Label heading = new Label();
    private final VBox content = new VBox();
    private final Set<String> collapsed = new HashSet<>();
    private final List<SectionPane> panes = new ArrayList<>();
    private final MaterialsPane materials;
    private final ReadyPane ready;
    private final ParametersPane parameters;
    private final MakersPane makers;
    /** Held here, for the model, which outlives the window's content, holds it weakly. */
    private final InvalidationListener onChange = property -> later();
    private final InvalidationListener onTime = property -> showKeys();
    private List<Section> sections = List.of();
    private boolean isStale;
    /** Until the sheet follows a drag again. */
    private final PauseTransition rest = new PauseTransition();
    /** When it last followed, {@link System#nanoTime}, and how long that took. */
    private long refreshed;
    private double tookMillis;
    private Runnable onFieldGone = () -> {};

    /**
     * @param proportional whether the three factors of a scale stay in proportion
     * @param finder asks for pictures
     * @param clock says for which time keys are set
     */
    public PropertySheet(EditorModel model, Texts texts, BooleanProperty proportional, FileFinder finder, Clock clock) {
        this.model = model;
        editors = new Editors(model, texts, proportional, finder, clock);
        titles = new Titles(texts);
        materials = new MaterialsPane(model, texts, editors);
        ready = new ReadyPane(model, texts);
        parameters = new ParametersPane(model, texts, clock);
        makers = new MakersPane(model, texts);
        setId("property-sheet");
        getStyleClass().add("property-sheet");
        getStylesheets().add(Objects.requireNonNull(PropertySheet.class.getResource("sheet.css")).toExternalForm());
        heading.setId("sheet-heading");
        heading.getStyleClass().add("sheet-heading");
        heading.setMaxWidth(Double.MAX_VALUE);
        ScrollPane scroll = new ScrollPane(content);
        scroll.setFitToWidth(true);
        // JavaFX keeps what is scrolled as a picture, and would make all of it anew for each digit that changes while something is dragged.
        scroll.skinProperty().addListener((property, old, now) -> scroll.lookup(".viewport").setCache(false));
        scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
        setTop(heading);
        setCenter(scroll);
        UndoKeys.reach(model, this);
        List.of(parameters, materials, ready).forEach(PropertySheet::passOpenTitle);
        addEventFilter(KeyEvent.KEY_PRESSED, this::toTitle);
        rest.setOnFinished(event -> refresh());
        WeakInvalidationListener weakly = new WeakInvalidationListener(onChange);
        model.stateProperty().addListener(weakly);
        model.gesturingProperty().addListener(weakly);
        WeakInvalidationListener weak = new WeakInvalidationListener(onTime);
        clock.secondsProperty().addListener(weak);
        clock.openProperty().addListener(weak);
        refresh();
    }

    /** What takes the material of something else, as a button beside that of what is selected. */
    public void offerPipette(Command pipette) {
        editors.offerPipette(pipette);
        // What is selected already, as when the language changes, has one, too.
        sections = List.of();
        refresh();
    }

    /** Is told when the field that had the keyboard is gone, and nothing in its place. */
    public void setOnFieldGone(Runnable listener) {
        onFieldGone = listener;
    }

    /** Once for all that changes before the window is drawn anew; while something is dragged, as often as the eye reads numbers, and the drag is not held up. */
    private void later() {
        boolean isDragged = model.gesturingProperty().get() && !isFocusWithin();
        if (isStale && (isDragged || rest.getStatus() != Animation.Status.RUNNING)) {
            return;
        }
        isStale = true;
        double millis = isDragged ? Math.max(READ_MILLIS, PART * tookMillis) - (System.nanoTime() - refreshed) / 1e6 : 0;
        rest.stop();
        if (millis > 0) {
            rest.setDuration(Duration.millis(millis));
            rest.playFromStart();
        } else {
            Platform.runLater(this::refresh);
        }
    }

    private void refresh() {
        long start = System.nanoTime();
        rest.stop();
        isStale = false;
        EditorState state = model.state();
        List<Section> now = Sections.of(state);
        heading.setText(titles.of(state));
        if (!now.equals(sections)) {
            sections = now;
            rebuild(state);
        }
        panes.forEach(pane -> pane.show(state.scene()));
        materials.show(state.scene());
        parameters.show(state.scene());
        makers.show(state.selection());
        refreshed = System.nanoTime();
        tookMillis = (refreshed - start) / 1e6;
    }

    private void showKeys() {
        panes.forEach(pane -> pane.showKeys(model.scene()));
        materials.showKeys(model.scene());
        parameters.showKeys(model.scene());
    }

    private void rebuild(EditorState state) {
        Optional<String> focused = focused();
        panes.clear();
        for (Section section : sections) {
            SectionPane pane = new SectionPane(titles.of(section), section, editors);
            pane.setExpanded(!collapsed.contains(section.title()));
            pane.expandedProperty().addListener((property, was, is) -> remember(section.title(), is));
            panes.add(pane);
        }
        content.getChildren().setAll(panes);
        content.getChildren().addAll(0, List.of(parameters, makers));
        if (state.selection().isEmpty()) {
            content.getChildren().add(materials);
        }
        // Lights and cameras have none.
        if (state.selection().isEmpty() || !Places.bodies(state.selection()).isEmpty()) {
            content.getChildren().add(ready);
        }
        focused.ifPresent(this::goOnAt);
    }

    /** Tab goes from field to field; it stops at the title of what is folded only, which could not be opened otherwise. */
    static void passOpenTitle(TitledPane pane) {
        pane.focusTraversableProperty().bind(pane.expandedProperty().not());
    }

    /** From within what can be folded, Ctrl+Up goes to its title, where Space folds it. */
    private void toTitle(KeyEvent event) {
        if (event.getCode() == KeyCode.UP && event.isShortcutDown() && !event.isAltDown() && !event.isShiftDown() && event.getTarget() instanceof Node from) {
            for (Node node = from; node != null && node != this; node = node.getParent()) {
                if (node instanceof TitledPane pane) {
                    pane.requestFocus();
                    event.consume();
                    return;
                }
            }
        }
    }

    /** Whoever was at a field goes on there: choosing another pattern, say, changes what is below the choice. */
    private void goOnAt(String id) {
        // What a section holds is found only when it has been made up.
        content.applyCss();
        Optional.ofNullable(content.lookup("#" + id)).ifPresentOrElse(Node::requestFocus, onFieldGone);
    }

    private void remember(String title, boolean expanded) {
        if (expanded) {
            collapsed.remove(title);
        } else {
            collapsed.add(title);
        }
    }

    /** The id of the field that has the focus; empty if none here has. */
    private Optional<String> focused() {
        Optional<Node> owner = Optional.ofNullable(getScene()).flatMap(scene -> Optional.ofNullable(scene.getFocusOwner()));
        return owner.filter(this::isWithin).flatMap(node -> Optional.ofNullable(node.getId()));
    }

    private boolean isWithin(Node node) {
        return node == content || (node.getParent() != null && isWithin(node.getParent()));
    }

    /** A heading with the properties under it. */
    private static final class SectionPane extends TitledPane {
        private final List<PropertyEditor> editors = new ArrayList<>();
        private final List<KeyButton> keys = new ArrayList<>();
        private final VBox rows = new VBox();

        SectionPane(String title, Section section, Editors factory) {
            setText(title);
            setAnimated(false);
            passOpenTitle(this);
            getStyleClass().add("sheet-section");
            rows.getStyleClass().add("sheet-rows");
            section.properties().stream().map(factory::entry).forEach(entry -> {
                rows.getChildren().add(entry.row());
                editors.add(entry.editor());
                entry.key().ifPresent(keys::add);
            });
            setContent(rows);
        }

        void show(Scene scene) {
            editors.forEach(editor -> editor.show(scene));
            showKeys(scene);
        }

        /** Shows which attributes have keys at the time that is looked at. */
        void showKeys(Scene scene) {
            keys.forEach(key -> key.show(scene));
        }
    }
}
