package cz.paprsek.fx.view.sheet;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.Screenshots;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Scene;
import java.util.List;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Keys of attributes, set where their values stand. */
class KeysInSheetTest {
    private static final Scene START = SheetInHand.scene("""
            <sphere name="ball" radius="1"><material reflection="0.2"><checker size="1" scale="2"/></material></sphere>
            """);

    private final SheetInHand sheet = SheetInHand.of(START);
    private final EditorModel model = sheet.model();
    private final Clock clock = sheet.clock();
    private final Gui gui = sheet.gui();

    @BeforeEach
    void selectTheBall() {
        sheet.select(START);
    }

    @AfterEach
    void close() {
        gui.close();
    }

    /** What is typed at a time becomes the value there, though an edit that cannot be seen leads to rest. */
    @Test
    void whatIsTypedIsTheValueOfTheKey() {
        assertThat(button("shape-radius").isVisible()).isFalse();
        gui.act(() -> {
            clock.openProperty().set(true);
            clock.look(2);
        });
        assertThat(button("shape-radius").getAccessibleText()).isEqualTo("Set a key at 2 s");
        gui.click("#shape-radius-key");
        assertThat(keys()).containsExactly(new Animation.Key(2, "1", Animation.Ease.LINEAR));
        gui.act(() -> clock.look(3));
        gui.click("#shape-radius");
        gui.act(() -> ((TextField) gui.stage().getScene().lookup("#shape-radius")).setText("1/2"));
        gui.keys(KeyCode.ALT, KeyCode.K);
        assertThat(keys()).containsExactly(new Animation.Key(2, "1", Animation.Ease.LINEAR), new Animation.Key(3, "0.5", Animation.Ease.LINEAR));
        assertThat(clock.secondsProperty().get()).hasValue(3);
        gui.act(model::undo);
        assertThat(keys()).hasSize(1);
    }

    /** A pattern has a scale, as the body has: what cannot be animated has no diamond. */
    @Test
    void onlyWhatCanBeAnimatedHasADiamond() {
        gui.act(() -> clock.openProperty().set(true));
        assertThat(List.of("placement-position", "placement-scale", "shape-radius", "shininess")).allMatch(id -> button(id).isVisible());
        assertThat(gui.stage().getScene().getRoot().lookupAll(".key-button")).filteredOn(Node::isVisible).extracting(Node::getId).noneMatch(id -> id.contains("pattern") || id.contains("color-"));
        Screenshots.save(gui, "keys-in-sheet");
    }

    @Test
    void parametersHaveKeysToo() {
        gui.act(() -> {
            clock.openProperty().set(true);
            clock.look(1);
        });
        gui.click("#parameter-w");
        gui.act(() -> ((TextField) gui.stage().getScene().lookup("#parameter-w")).setText("4"));
        gui.keys(KeyCode.ALT, KeyCode.K);
        assertThat(model.scene().animations()).singleElement().extracting(Animation::target).isEqualTo("param:w");
        assertThat(keys()).containsExactly(new Animation.Key(1, "4", Animation.Ease.LINEAR));
    }

    private Button button(String id) {
        return (Button) Gui.on(() -> gui.stage().getScene().lookup("#" + id + "-key"));
    }

    private List<Animation.Key> keys() {
        return model.scene().animations().stream().flatMap(one -> one.keys().stream()).toList();
    }
}
