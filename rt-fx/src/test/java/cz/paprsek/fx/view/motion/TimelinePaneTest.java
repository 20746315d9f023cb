package cz.paprsek.fx.view.motion;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.util.List;
import java.util.Locale;
import javafx.beans.property.SimpleObjectProperty;
import javafx.event.ActionEvent;
import javafx.scene.control.Button;
import javafx.scene.control.MenuButton;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignP;

/** The timeline by mouse and keys. */
class TimelinePaneTest {
    private final EditorModel model = new EditorModel(Scene.EMPTY);
    private final Clock clock = Gui.on(() -> new Clock(model));
    private final Edits edits = new Edits(model, Texts.in(Locale.ENGLISH));
    private final Gui gui = Gui.show(() -> {
        model.open(scene());
        return new TimelinePane(edits, clock, new SimpleObjectProperty<>(Theme.LIGHT));
    }, 620, 150);
    private final TrackCanvas tracks = (TrackCanvas) gui.node("#timeline-tracks");

    private static Scene scene() {
        try {
            return SceneFiles.parse("<scene xmlns=\"urn:paprsek:scene:1\"><camera position=\"0 2 8\" target=\"0 1 0\"/><sphere name=\"ball\" radius=\"1\" position=\"0 1 0\"/>"
                    + "<animate target=\"ball\" attribute=\"position\"><key t=\"0\" value=\"0 1 0\"/><key t=\"1\" value=\"1 1 0\"/><key t=\"2\" value=\"0 1 0\"/></animate></scene>");
        } catch (SceneFileException wrong) {
            throw new AssertionError(wrong);
        }
    }

    @AfterEach
    void close() {
        gui.close();
    }

    private List<Double> times() {
        return model.scene().animations().get(0).keys().stream().map(Animation.Key::t).toList();
    }

    private double x(int frame) {
        return Gui.on(() -> tracks.x(frame));
    }

    private double row() {
        return Gui.on(() -> tracks.y(0));
    }

    @Test
    void theMouseScrubsAndTakesKeysToOtherTimes() {
        gui.click(tracks, x(11), 8);
        assertThat(clock.time()).isEqualTo(0.4);
        gui.drag(tracks, x(26), row(), x(36), row());
        assertThat(times()).containsExactly(0.0, 1.4, 2.0);
        gui.act(model::undo);
        assertThat(times()).as("one step").containsExactly(0.0, 1.0, 2.0);
    }

    @Test
    void keysDoAllOfIt() {
        gui.click(tracks, x(1), 8);
        gui.keys(KeyCode.DOWN);
        gui.keys(KeyCode.PAGE_DOWN);
        assertThat(clock.time()).isEqualTo(1);
        gui.keys(KeyCode.ALT, KeyCode.RIGHT);
        assertThat(times()).containsExactly(0.0, 1.04, 2.0);
        gui.keys(KeyCode.E);
        assertThat(model.scene().animations().get(0).keys().get(1).ease()).isEqualTo(Animation.Ease.SMOOTH);
        gui.keys(KeyCode.DELETE);
        assertThat(times()).containsExactly(0.0, 2.0);
        gui.keys(KeyCode.END);
        assertThat(clock.frame()).isEqualTo(51);
        gui.keys(KeyCode.SPACE);
        gui.until("it plays", () -> clock.frame() != 51);
        gui.keys(KeyCode.ESCAPE);
        assertThat(clock.secondsProperty().get()).as("at rest").isEmpty();
    }

    @Test
    void playingEndsWhereAnEditLeadsToRest() {
        gui.click(tracks, x(1), 8);
        gui.keys(KeyCode.SPACE);
        gui.until("it plays", () -> clock.frame() > 1);
        gui.act(clock::rest);
        gui.until("it plays no more", () -> gui.node("#timeline-play") instanceof Button play && play.getGraphic() instanceof FontIcon icon && icon.getIconCode() == MaterialDesignP.PLAY);
        assertThat(clock.secondsProperty().get()).isEmpty();
    }

    @Test
    void aPaneThatIsClosedLeavesTheClockAlone() {
        TimelinePane pane = (TimelinePane) gui.node("#timeline");
        gui.act(() -> clock.look(1));
        gui.act(pane::close);
        gui.act(() -> clock.openProperty().set(false));
        assertThat(clock.secondsProperty().get()).as("it rests no clock any more").isPresent();
    }

    @Test
    void aRangeHasALastFrameAndWhatIsNoRangeIsRefusedInOneSentence() {
        TextField range = (TextField) gui.node("#timeline-range");
        for (String wrong : List.of("1-2147483647", "1-99999999999", "5-2", "x")) {
            gui.act(() -> {
                range.setText(wrong);
                range.fireEvent(new ActionEvent());
            });
            assertThat(edits.refusalProperty().get()).as(wrong).isEqualTo("a range must be two frames from 1 to 10,000,000, such as 1-100");
        }
        gui.act(() -> {
            range.setText("1-10000000");
            range.fireEvent(new ActionEvent());
        });
        assertThat(clock.span()).isEqualTo(new Clock.Span(1, 10_000_000));
        assertThat(edits.refusalProperty().get()).isEmpty();
    }

    @Test
    void valuesAreTypedAndKeysAddedForWhatIsSelected() {
        gui.click(tracks, x(26), row());
        TextField value = (TextField) gui.node("#timeline-value");
        gui.act(() -> {
            value.setText("1 5 0");
            value.fireEvent(new ActionEvent());
        });
        assertThat(model.scene().animations().get(0).keys().get(1).value()).isEqualTo("1 5 0");
        gui.act(() -> model.select(ScenePath.body(0)));
        gui.act(() -> clock.look(0.4));
        MenuButton add = (MenuButton) gui.node("#timeline-add");
        gui.act(() -> add.getOnShowing().handle(null));
        gui.act(() -> add.getItems().stream().filter(item -> "timeline-add-radius".equals(item.getId())).findFirst().orElseThrow().fire());
        assertThat(model.scene().animations()).hasSize(2);
        assertThat(model.scene().animations().get(1).keys()).extracting(Animation.Key::t).containsExactly(0.4);
    }
}
