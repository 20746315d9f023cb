package cz.paprsek.fx.view.motion;

import cz.paprsek.attribute.Described;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.model.motion.Keys;
import cz.paprsek.fx.model.motion.Keys.KeyAt;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Animation.Ease;
import cz.paprsek.scene.Scene;
import java.util.List;
import java.util.Optional;
import javafx.beans.InvalidationListener;
import javafx.beans.WeakInvalidationListener;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.geometry.VPos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.util.StringConverter;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignD;
import org.kordamp.ikonli.materialdesign2.MaterialDesignP;
import org.kordamp.ikonli.materialdesign2.MaterialDesignS;

/** The strip below the views: which time is looked at, playing, and the keys of what is selected, or of all that is animated. */
public final class TimelinePane extends VBox {
    private static final List<Ease> EASES = List.of(Ease.values());

    private final EditorModel model;
    private final Edits edits;
    private final Texts texts;
    private final Clock clock;
    private final TrackCanvas tracks;
    private final Button play = new Button("", new FontIcon(MaterialDesignP.PLAY));
    private final TextField seconds = field("timeline-seconds", 4);
    private final TextField frame = field("timeline-frame", 3);
    private final TextField range = field("timeline-range", 5);
    private final MenuButton add;
    private final TextField value = field("timeline-value", 9);
    private final ComboBox<Ease> ease = new ComboBox<>();
    private final HBox keyRow;
    private final Label refusal = new Label();
    private final Player player;
    /** Held here, for what outlives the window's content holds it weakly. */
    private final InvalidationListener onChange = changed -> show();
    private final ChangeListener<Boolean> onOpen = (property, was, is) -> show(is);
    private boolean shows;

    public TimelinePane(Edits edits, Clock clock, ObservableValue<Theme> theme) {
        this.model = edits.model();
        this.edits = edits;
        this.texts = edits.texts();
        this.clock = clock;
        tracks = new TrackCanvas(edits, clock, theme);
        add = new KeyMenu(edits, clock).button();
        player = new Player(model, clock, runs -> play.setGraphic(new FontIcon(runs ? MaterialDesignP.PAUSE : MaterialDesignP.PLAY)));
        setId("timeline");
        getStyleClass().add("timeline");
        describe(seconds, "timeline.seconds-hint");
        describe(frame, "timeline.frame-hint");
        describe(range, "timeline.range-hint");
        describe(value, "timeline.value-hint");
        button(play, "timeline-play", "timeline.play", this::playOrStop);
        Button rest = button(new Button("", new FontIcon(MaterialDesignS.STOP)), "timeline-rest", "timeline.rest", this::rest);
        Button delete = button(icon(MaterialDesignD.DELETE_OUTLINE), "timeline-delete", "timeline.delete", this::delete);
        Button close = button(icon(MaterialDesignC.CLOSE), "timeline-close", "timeline.close", () -> clock.openProperty().set(false));
        ease.getItems().setAll(EASES);
        ease.setId("timeline-ease");
        ease.setPrefWidth(124);
        ease.setConverter(new StringConverter<>() {
            @Override
            public String toString(Ease one) {
                return one == null ? "" : texts.of("ease." + Described.word(one));
            }

            @Override
            public Ease fromString(String text) {
                throw new UnsupportedOperationException("not editable");
            }
        });
        Hint.of(ease).set(texts.of("timeline.ease"));
        ease.setAccessibleText(texts.of("timeline.ease"));
        ease.setOnAction(event -> {
            if (!shows && ease.getValue() != null) {
                changeKey((scene, key) -> Keys.eased(scene, key, ease.getValue()));
            }
        });
        onEnter(seconds, text -> clock.look(Double.parseDouble(text.replace(',', '.').replace("s", "").strip())));
        onEnter(frame, text -> clock.lookAtFrame(Integer.parseInt(text.strip())));
        onEnter(range, this::choose);
        onEnter(value, text -> changeKey((scene, key) -> Keys.valued(scene, key, text.replace(',', '.'))));
        HBox time = row(play, rest, seconds, label("timeline.seconds-unit"), label("timeline.frame"), frame, label("timeline.of"), range);
        keyRow = row(label("timeline.key"), value, ease, delete);
        FlowPane head = new FlowPane(10, 2, time, row(add), keyRow, refusal);
        refusal.setId("timeline-refusal");
        refusal.maxWidthProperty().bind(head.widthProperty());
        Hint.of(refusal).bind(refusal.textProperty());
        refusal.visibleProperty().bind(refusal.textProperty().isNotEmpty());
        refusal.managedProperty().bind(refusal.visibleProperty());
        head.setRowValignment(VPos.CENTER);
        HBox.setHgrow(head, Priority.ALWAYS);
        HBox line = new HBox(head, close);
        line.getStyleClass().add("timeline-head");
        VBox.setVgrow(tracks, Priority.ALWAYS);
        getChildren().addAll(line, tracks);
        setMinWidth(0);
        setMinHeight(Region.USE_PREF_SIZE);
        WeakInvalidationListener weak = new WeakInvalidationListener(onChange);
        model.stateProperty().addListener(weak);
        clock.secondsProperty().addListener(weak);
        theme.addListener(weak);
        clock.openProperty().addListener(onOpen);
        tracks.chosenProperty().addListener((property, old, now) -> showKey());
        addEventHandler(KeyEvent.KEY_PRESSED, this::pressed);
        show(clock.openProperty().get());
    }

    private void show(boolean is) {
        setVisible(is);
        setManaged(is);
        if (is) {
            show();
        } else {
            player.stop();
            clock.rest();
        }
    }

    /** Ends playing, and lets go of the clock, which outlives the window's content. */
    public void close() {
        player.stop();
        clock.openProperty().removeListener(onOpen);
    }

    /** Gives the keyboard to the tracks. */
    @Override
    public void requestFocus() {
        tracks.requestFocus();
    }

    private void show() {
        if (!isVisible()) {
            return;
        }
        shows = true;
        if (!seconds.isFocused()) {
            seconds.setText(texts.number(TrackCanvas.seconds(clock.time())));
        }
        if (!frame.isFocused()) {
            frame.setText(String.valueOf(clock.frame()));
        }
        if (!range.isFocused()) {
            range.setText(clock.span().from() + "-" + clock.span().to());
        }
        shows = false;
        refusal.setText(texts.sentence(clock.refusal()));
        showKey();
        tracks.requestLayout();
        requestLayout();
    }

    private void showKey() {
        Optional<KeyAt> chosen = tracks.chosenProperty().get().filter(key -> key.isIn(model.scene()));
        shows = true;
        keyRow.setDisable(chosen.isEmpty());
        if (!value.isFocused() || chosen.isEmpty()) {
            value.setText(chosen.map(key -> texts.number(key.in(model.scene()).value())).orElse(""));
        }
        ease.setValue(chosen.map(key -> key.in(model.scene()).ease()).orElse(null));
        shows = false;
    }

    private void choose(String text) {
        clock.choose(text.isBlank() ? Optional.empty() : Optional.of(span(text.strip().split("\\s*[-–]\\s*", -1))));
        show();
    }

    private Clock.Span span(String[] ends) {
        try {
            return new Clock.Span(Integer.parseInt(ends[0]), Integer.parseInt(ends[ends.length - 1]));
        } catch (IllegalArgumentException none) {
            throw new IllegalArgumentException(texts.of("timeline.no-range", String.format(texts.locale(), "%,d", Clock.Span.LAST)), none);
        }
    }

    private interface KeyChange {
        Scene of(Scene scene, KeyAt key);
    }

    private void changeKey(KeyChange change) {
        tracks.chosenProperty().get().filter(key -> key.isIn(model.scene())).ifPresent(key ->
                edits.attempt(() -> model.edit(tracks.label(key.animation()), scene -> change.of(scene, key))));
    }

    private void delete() {
        changeKey(Keys::removed);
        tracks.chosenProperty().set(Optional.empty());
    }

    private void rest() {
        player.stop();
        clock.rest();
    }

    private void playOrStop() {
        if (player.runs()) {
            player.stop();
        } else {
            player.start();
        }
    }

    private void pressed(KeyEvent event) {
        boolean isInField = event.getTarget() instanceof TextField;
        if (isInField || event.isShortcutDown()) {
            return;
        }
        if (act(event)) {
            event.consume();
        }
    }

    /** Whether the key means something here. */
    private boolean act(KeyEvent event) {
        KeyCode code = event.getCode();
        if (code == KeyCode.SPACE) {
            playOrStop();
        } else if (code == KeyCode.ESCAPE) {
            if (!tracks.cancel()) {
                rest();
            }
        } else if (code == KeyCode.LEFT || code == KeyCode.RIGHT) {
            step(code == KeyCode.LEFT ? -1 : 1, event.isShiftDown() ? 10 : 1, event.isAltDown());
        } else if (code == KeyCode.HOME || code == KeyCode.END) {
            clock.lookAtFrame(code == KeyCode.HOME ? clock.span().from() : clock.span().to());
        } else if (code == KeyCode.UP || code == KeyCode.DOWN) {
            track(code == KeyCode.UP ? -1 : 1);
        } else if (code == KeyCode.PAGE_UP || code == KeyCode.PAGE_DOWN) {
            neighbour(code == KeyCode.PAGE_UP ? -1 : 1);
        } else if (code == KeyCode.INSERT || code == KeyCode.K) {
            add.fire();
        } else if (code == KeyCode.DELETE || code == KeyCode.BACK_SPACE) {
            delete();
        } else if (code == KeyCode.E) {
            changeKey((scene, key) -> Keys.eased(scene, key, EASES.get((EASES.indexOf(key.in(scene).ease()) + 1) % EASES.size())));
        } else {
            return false;
        }
        return true;
    }

    private void step(int way, int frames, boolean takesKey) {
        double t = model.scene().settings().seconds(Math.max(1, clock.frame() + way * frames));
        Optional<KeyAt> key = tracks.chosenProperty().get();
        if (takesKey && key.isPresent()) {
            double to = model.scene().settings().seconds(Math.max(1, clock.frame(key.get().in(model.scene()).t()) + way * frames));
            changeKey((scene, one) -> Keys.moved(scene, one, to));
            tracks.chosenProperty().set(Keys.at(model.scene(), key.get().animation(), to));
            clock.look(to);
        } else {
            clock.look(t);
        }
    }

    /** To the key that is nearest in time on the next track. */
    private void track(int way) {
        List<Integer> all = tracks.tracks();
        if (all.isEmpty()) {
            return;
        }
        int now = tracks.chosenProperty().get().map(key -> all.indexOf(key.animation())).orElse(way > 0 ? -1 : all.size());
        int animation = all.get(Math.max(0, Math.min(all.size() - 1, now + way)));
        List<Animation.Key> keys = model.scene().animations().get(animation).keys();
        int nearest = 0;
        for (int i = 0; i < keys.size(); i++) {
            nearest = Math.abs(keys.get(i).t() - clock.time()) < Math.abs(keys.get(nearest).t() - clock.time()) ? i : nearest;
        }
        if (!keys.isEmpty()) {
            tracks.choose(new KeyAt(animation, nearest));
        }
    }

    /** To the next key of the track. */
    private void neighbour(int way) {
        tracks.chosenProperty().get().map(key -> new KeyAt(key.animation(), key.key() + way)).filter(key -> key.key() >= 0 && key.isIn(model.scene())).ifPresentOrElse(tracks::choose, () -> {
            if (tracks.chosenProperty().get().isEmpty()) {
                track(way);
            }
        });
    }

    private static TextField field(String id, int columns) {
        TextField field = new TextField();
        field.setId(id);
        field.setPrefColumnCount(columns);
        field.setMinWidth(Region.USE_PREF_SIZE);
        return field;
    }

    private void describe(TextField field, String key) {
        Hint.of(field).set(texts.of(key));
        field.setAccessibleText(texts.of(key));
    }

    private interface Entering {
        void enter(String text);
    }

    private void onEnter(TextField field, Entering entering) {
        field.setOnAction(event -> {
            edits.attempt(() -> entered(entering, field.getText()));
            tracks.requestFocus();
            show();
        });
        field.focusedProperty().addListener((property, was, is) -> {
            if (!is) {
                show();
            }
        });
        field.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                tracks.requestFocus();
                event.consume();
            }
        });
    }

    private void entered(Entering entering, String text) {
        try {
            entering.enter(text);
        } catch (NumberFormatException none) {
            throw new IllegalArgumentException(texts.of("timeline.no-number", text), none);
        }
    }

    private Label label(String key) {
        Label label = new Label(texts.of(key));
        label.setMinWidth(Region.USE_PREF_SIZE);
        return label;
    }

    private static Button icon(Ikon icon) {
        return new Button("", new FontIcon(icon));
    }

    private Button button(Button button, String id, String key, Runnable action) {
        button.setId(id);
        button.getStyleClass().add("view-button");
        Hint.of(button).set(texts.of(key));
        button.setAccessibleText(texts.of(key));
        button.setFocusTraversable(false);
        button.setOnAction(event -> action.run());
        return button;
    }

    private static HBox row(Node... nodes) {
        HBox row = new HBox(5, nodes);
        row.setAlignment(Pos.CENTER_LEFT);
        return row;
    }
}
