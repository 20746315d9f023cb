package cz.paprsek.fx.model.typing;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.Label;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Sphere;
import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Queue;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Text that is written in while the scene is edited, where what takes long ends when the test says so. */
class LateManuscriptTest {
    private static final Scene TWO = Scene.EMPTY.plus(SceneObject.of(new Sphere(1)).named("a"), SceneObject.of(new Sphere(2)).named("b"));
    private static final Sphere WRITTEN = new Sphere(1.5);
    private static final Placement ELSEWHERE = Placement.at(7, 0, 0);

    private final Queue<Runnable> under = new ArrayDeque<>();
    private final EditorModel model = new EditorModel(TWO);
    private final Manuscript text = new Manuscript(model, () -> model.state().typed(), new ByExecutor(under::add));

    @BeforeEach
    void open() {
        text.openProperty().set(true);
        finish();
        assertThat(text.page().text()).contains("radius=\"1\"");
    }

    private void finish() {
        while (!under.isEmpty()) {
            under.remove().run();
        }
    }

    private void write(String radius) {
        text.write(text.page().text().replace("radius=\"1\"", "radius=\"" + radius + "\""));
    }

    private void move() {
        model.edit(Label.of(Label.Edit.MOVE), LateManuscriptTest::moved);
    }

    private static Scene moved(Scene scene) {
        return scene.with(ScenePath.body(1), one -> one.placed(ELSEWHERE));
    }

    private void expectBoth() {
        assertThat(model.scene().objects().get(0).shape()).isEqualTo(WRITTEN);
        assertThat(model.scene().objects().get(1).placement()).isEqualTo(ELSEWHERE);
        assertThat(text.page().text()).contains("radius=\"1.5\"").contains("position=\"7 0 0\"");
        assertThat(text.page().isHeld()).isFalse();
    }

    @Test
    void whatIsMovedWhileTheTextIsLookedAtStaysMoved() {
        write("1.5");
        text.check();
        move();
        finish();
        expectBoth();
    }

    @Test
    void whatIsMovedWhileTheTextIsBehindStaysMoved() {
        write("1.5");
        move();
        text.check();
        finish();
        expectBoth();
        model.undo();
        finish();
        assertThat(model.scene()).as("each is a step of its own").isEqualTo(moved(TWO));
    }

    @Test
    void whatIsMovedJustBeforeSavingIsSavedWithTheText() {
        write("1.5");
        move();
        assertThat(text.flush()).isTrue();
        expectBoth();
        finish();
        expectBoth();
    }

    @Test
    void whatIsWrongWhenSavingStaysWrittenBesideTheMove() {
        write("-1");
        move();
        assertThat(text.flush()).isFalse();
        finish();
        assertThat(text.page().problems()).hasSize(1);
        assertThat(text.page().text()).contains("radius=\"-1\"").contains("position=\"7 0 0\"");
        assertThat(model.scene()).isEqualTo(moved(TWO));
    }

    @Test
    void anEqualSceneThatIsOpenedIsShownToo() {
        for (int i = 0; i < 2; i++) {
            model.open(TWO);
            finish();
            assertThat(text.page().text()).contains("radius=\"1\"");
            write("1.5");
            text.check();
            finish();
            assertThat(model.scene().objects().get(0).shape()).isEqualTo(WRITTEN);
            model.undo();
            finish();
        }
        model.open(TWO);
        model.open(TWO);
        finish();
        assertThat(text.page().text()).contains("radius=\"1\"");
    }

    @Test
    void whatIsBeingDraggedIsWaitedFor() {
        for (boolean isKept : new boolean[]{false, true}) {
            write("1.5");
            text.check();
            Gesture drag = model.begin(Label.of(Label.Edit.MOVE));
            drag.preview(LateManuscriptTest::moved);
            text.check();
            finish();
            assertThat(drag.isOpen()).isTrue();
            assertThat(model.scene()).isEqualTo(moved(TWO));
            assertThat(text.page().isHeld()).isTrue();
            if (isKept) {
                drag.commit();
                finish();
                expectBoth();
            } else {
                drag.cancel();
                finish();
                assertThat(model.scene()).isEqualTo(TWO.with(ScenePath.body(0), one -> one.withShape(WRITTEN)));
                model.undo();
                finish();
            }
        }
    }

    @Test
    void aDragThatComesToNothingHoldsNothingUp() {
        Gesture drag = model.begin(Label.of(Label.Edit.MOVE));
        write("1.5");
        text.check();
        finish();
        assertThat(text.page().isHeld()).isTrue();
        drag.cancel();
        finish();
        assertThat(text.page().isHeld()).isFalse();
        assertThat(model.undoableProperty().get()).isEqualTo(Optional.of(Label.of(Label.Edit.WRITE, "XML")));
    }
}
