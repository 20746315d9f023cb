package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import cz.paprsek.teach.mistake.Mistake;
import java.nio.file.Path;
import java.util.Locale;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.TextArea;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MistakesWindowTest {
    private static final Scene BALL = Scene.EMPTY.withSettings(RenderSettings.DEFAULT.withSize(80, 60)).plus(Light.at(3, 4, 5)).plus(SceneObject.of(new Sphere(1)).at(0, 1, 0));

    @TempDir
    Path folder;

    @Test
    void theWrongPictureStandsBesideTheRightOneAndAClickTellsTheNumbers() {
        EditorGui editor = new EditorGui(folder, BALL);
        try {
            editor.menu("render-menu-mistakes");
            Gui gui = Gui.open(() -> editor.editor.mistakes().stage().orElseThrow());
            gui.until("the right picture is there", () -> picture(gui, "right") != null);
            assertThat(Gui.on(() -> same(gui))).isTrue();
            gui.act(() -> list(gui).getSelectionModel().select(Mistake.FULL_FOVY));
            gui.until("the wrong picture is another", () -> !same(gui));
            assertThat(Gui.on(() -> ((Label) gui.node("#mistakes-lines")).getText())).contains("the whole vertical angle", "h = 2·tan(fovy)", "right:   h = 2·tan(fovy/2)");
            gui.pulse();
            // The middle of a pixel: a centred window may stand at half a one.
            gui.click(gui.node("#mistakes-wrong"), 40.5, 30.5);
            assertThat(Gui.on(() -> ((TextArea) gui.node("#mistakes-numbers")).getText())).contains("pixel 40,30", "* h            0.82843");
            gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
            gui.act(() -> list(gui).getSelectionModel().select(Mistake.FULL_FOVY));
            assertThat(Gui.on(() -> ((Label) gui.node("#mistakes-lines")).getText())).contains("celý svislý úhel");
            gui.until("the picture is there", () -> picture(gui, "wrong") != null);
            gui.pulse();
            gui.click(gui.node("#mistakes-wrong"), 40.5, 30.5);
            assertThat(Gui.on(() -> ((TextArea) gui.node("#mistakes-numbers")).getText())).contains("* h            0,82843", "paprsek ").doesNotContain("ray");
        } finally {
            editor.close();
        }
    }

    /** Pictures are small, so that each mistake shows at once; the pixels are those of the picture in full. */
    @Test
    void numbersAreThoseOfThePixelInFull() {
        EditorGui editor = new EditorGui(folder, BALL.withSettings(BALL.settings().withSize(640, 480)));
        try {
            editor.menu("render-menu-mistakes");
            Gui gui = Gui.open(() -> editor.editor.mistakes().stage().orElseThrow());
            gui.until("the right picture is there", () -> picture(gui, "right") != null);
            gui.pulse();
            gui.click(gui.node("#mistakes-right"), 40.5, 30.5);
            assertThat(Gui.on(() -> ((TextArea) gui.node("#mistakes-numbers")).getText())).contains("pixel 81,61");
        } finally {
            editor.close();
        }
    }

    /** A large window has large pictures; the pixels are those of the picture in full there, too. */
    @Test
    void picturesGrowWithTheWindow() {
        EditorGui editor = new EditorGui(folder, BALL.withSettings(BALL.settings().withSize(960, 600)));
        try {
            editor.menu("render-menu-mistakes");
            Gui gui = Gui.open(() -> editor.editor.mistakes().stage().orElseThrow());
            gui.act(() -> gui.stage().setWidth(1590));
            gui.until("the right picture is larger", () -> picture(gui, "right") != null && picture(gui, "right").getWidth() == 400);
            gui.until("so is where it is shown", () -> gui.node("#mistakes-right").getLayoutBounds().getWidth() == 400);
            gui.pulse();
            gui.click(gui.node("#mistakes-right"), 50.5, 30.5);
            assertThat(Gui.on(() -> ((TextArea) gui.node("#mistakes-numbers")).getText())).contains("pixel 121,73");
        } finally {
            editor.close();
        }
    }

    @Test
    void whatThePlainTracerDoesNotKnowIsNamed() {
        EditorGui editor = new EditorGui(folder, BALL.plus(SceneObject.of(new Torus(1, 0.2))));
        try {
            editor.menu("render-menu-mistakes");
            Gui gui = Gui.open(() -> editor.editor.mistakes().stage().orElseThrow());
            assertThat(Gui.on(() -> ((Label) gui.node("#mistakes-lines")).getText())).contains("torus");
            gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
            assertThat(Gui.on(() -> ((Label) gui.node("#mistakes-lines")).getText())).contains("anuloid");
        } finally {
            editor.close();
        }
    }

    @SuppressWarnings("unchecked")
    private static ListView<Mistake> list(Gui gui) {
        return (ListView<Mistake>) gui.node("#mistakes-list");
    }

    private static Image picture(Gui gui, String which) {
        return ((ImageView) gui.node("#mistakes-" + which)).getImage();
    }

    private static boolean same(Gui gui) {
        Image right = picture(gui, "right");
        Image wrong = picture(gui, "wrong");
        for (int i = 0; i < 80 * 60; i++) {
            if (right.getPixelReader().getArgb(i % 80, i / 80) != wrong.getPixelReader().getArgb(i % 80, i / 80)) {
                return false;
            }
        }
        return true;
    }
}
