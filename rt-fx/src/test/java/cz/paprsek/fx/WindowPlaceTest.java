package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.file.Settings;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import javafx.geometry.Rectangle2D;
import javafx.scene.Scene;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.layout.StackPane;
import javafx.stage.Screen;
import javafx.stage.Stage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WindowPlaceTest {
    @TempDir
    Path folder;

    @Test
    void aWindowOpensWhereItWasClosed() {
        try (Gui first = open(new AtomicBoolean())) {
            first.pulse();
            first.act(() -> {
                first.stage().setX(60);
                first.stage().setY(40);
                first.stage().setWidth(700);
                first.stage().setHeight(500);
            });
        }
        AtomicBoolean unknown = new AtomicBoolean();
        try (Gui second = open(unknown)) {
            second.until("it has its size and place", () -> second.stage().getWidth() == 700 && second.stage().getHeight() == 500
                    && second.stage().getX() == 60 && second.stage().getY() == 40);
        }
        assertThat(unknown.get()).isFalse();
    }

    /** Measured with the sizes of the theme alone it would be higher than the screen has room below the bar. */
    @Test
    void theLongestMenuOpensBelowTheBarTheFirstTime() {
        EditorGui editor = new EditorGui(folder, cz.paprsek.scene.Scene.EMPTY);
        try {
            MenuBar bar = (MenuBar) editor.gui.node("#menu-bar");
            Menu menu = bar.getMenus().stream().filter(known -> "menu-object".equals(known.getId())).findFirst().orElseThrow();
            editor.gui.act(menu::show);
            double first = top(menu);
            editor.gui.act(menu::hide);
            editor.gui.act(menu::show);
            assertThat(first).isEqualTo(top(menu)).isGreaterThan(Gui.on(() -> bar.localToScreen(0, 0.5 * bar.getHeight()).getY()));
            editor.gui.act(menu::hide);
        } finally {
            editor.close();
        }
    }

    private static double top(Menu menu) {
        return Gui.on(() -> menu.getItems().get(0).getParentPopup().getAnchorY());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "far away", "1 2 3", "-5000 0 800 600", "9000 9000 800 600"})
    void aPlaceThatIsNoneIsPassedOver(String text) {
        Gui.on(() -> {
            settings().set("window", text);
            return true;
        });
        AtomicBoolean unknown = new AtomicBoolean();
        open(unknown).close();
        assertThat(unknown.get()).isTrue();
    }

    /** A window that has its size before it is shown is painted whole at first, and not a corner of it. */
    @Test
    void aWindowHasItsSizeBeforeItIsShown() {
        Rectangle2D room = Gui.on(() -> Screen.getPrimary().getVisualBounds());
        List<Double> known = Gui.on(() -> {
            settings().set("window", "60 40 700 500");
            Stage stage = new Stage();
            WindowPlace.keep(stage, settings(), "window", () -> {});
            return List.of(stage.getWidth(), stage.getHeight());
        });
        assertThat(known).containsExactly(700.0, 500.0);
        assertThat(Gui.on(() -> {
            Stage stage = new Stage();
            Sizes.mostOfTheScreen(stage, 640, 480);
            return List.of(stage.getWidth(), stage.getHeight());
        })).containsExactly(0.85 * room.getWidth(), 0.85 * room.getHeight());
        assertThat(Gui.on(() -> {
            Stage stage = new Stage();
            Sizes.mostOfTheScreen(stage, 4000, 480);
            return List.of(stage.getWidth(), stage.getHeight(), stage.isMaximized());
        })).containsExactly(0.85 * room.getWidth(), 480.0, true);
    }

    @Test
    void aWindowIsSeenAsSoonAsItHasBeenPainted() {
        AtomicReference<Double> first = new AtomicReference<>(1.0);
        try (Gui window = Gui.open(() -> {
            Stage stage = new Stage();
            stage.setScene(new Scene(new StackPane(), 200, 100));
            WindowPlace.keep(stage, settings(), "window", () -> {});
            stage.show();
            first.set(stage.getOpacity());
            return stage;
        })) {
            assertThat(first).hasValue(0.0);
            window.until("it is seen", () -> window.stage().getOpacity() == 1);
        }
    }

    @Test
    void textsAreReadBack() {
        assertThat(WindowPlace.parse("10 -20 800 600 maximized")).get().extracting(WindowPlace::text).isEqualTo("10 -20 800 600 maximized");
        assertThat(WindowPlace.parse("10 -20 800 600")).get().extracting(WindowPlace::maximized).isEqualTo(false);
    }

    private Settings settings() {
        return new Settings(folder, fault -> {
            throw new AssertionError(fault);
        });
    }

    private Gui open(AtomicBoolean unknown) {
        return Gui.open(() -> {
            Stage stage = new Stage();
            stage.setScene(new Scene(new StackPane(), 300, 200));
            WindowPlace.keep(stage, settings(), "window", () -> unknown.set(true));
            return stage;
        });
    }
}
