package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.fx.model.edit.Structure;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The window worked in for long, its picture being rendered anew all the while. */
class EditSoakTest {
    /** Ten with the proofs, of two hundred edits each. */
    private static final int ROUNDS = Integer.getInteger("paprsek.rounds", 4);
    private static final int EDITS = ROUNDS < 10 ? 80 : 200;
    private static final long MOST_MORE = 16_000_000;
    private static final int AT_ONCE = 40;

    @TempDir
    Path folder;

    @Test
    void editsAllUndoneLeaveTheSceneAndTheMemoryAsTheyWere() throws Exception {
        Scene start = SceneFiles.read(Path.of("../scenes/showcase.xml"));
        try (EditorGui editor = new EditorGui(folder.resolve("settings"), start)) {
            EditorModel model = editor.model();
            Random random = new Random(3);
            long early = 0;
            for (int round = 0; round < ROUNDS; round++) {
                for (int i = 0; i < EDITS; i += AT_ONCE) {
                    editor.gui.act(() -> {
                        for (int k = 0; k < AT_ONCE; k++) {
                            edit(model, random);
                        }
                    });
                }
                assertThat(model.scene()).isNotEqualTo(start);
                for (int i = 0; i < EDITS; i += AT_ONCE) {
                    editor.gui.act(() -> {
                        for (int k = 0; k < AT_ONCE; k++) {
                            model.undo();
                        }
                    });
                }
                assertThat(model.scene()).isSameAs(start);
                assertThat(model.undoableProperty().get()).isEmpty();
                // The most of some rounds: whether the last picture's buffers are let go by then is chance.
                if (round == ROUNDS / 3 || round == ROUNDS / 3 - 1) {
                    early = Math.max(early, usedAtRest(editor));
                }
            }
            // A picture more or less is 11 MB; a window's worth of nodes kept for every edit would be hundreds.
            long late = usedAtRest(editor);
            for (int i = 0; i < 10 && late - early >= MOST_MORE; i++) {
                // What another thread has just let go of, or is about to, is not kept: what is kept is still there later.
                Thread.sleep(300);
                late = Math.min(late, usedAtRest(editor));
            }
            assertThat(late - early).as("bytes more after %d edits", ROUNDS * EDITS).isLessThan(MOST_MORE);
        }
    }

    /** One step of history whatever comes; object 0 is the table, which has no inside, and stays. */
    private static void edit(EditorModel model, Random random) {
        int objects = model.scene().objects().size();
        ScenePath one = ScenePath.body(1 + random.nextInt(objects - 1));
        EditorState state = model.state();
        switch (objects < 6 ? 0 : random.nextInt(6)) {
            case 0 -> model.edit(Label.of(Label.Edit.ADD), scene -> scene.plus(SceneObject.of(new Sphere(0.1 + random.nextDouble())).at(random.nextDouble(), 1, 0)));
            case 1 -> model.edit(Label.of(Label.Edit.MOVE), scene -> Moves.translated(scene, Set.of(one), new Vec3(0.1, random.nextDouble(), 0)));
            case 2 -> model.editState(Label.of(Label.Edit.DUPLICATE), now -> Structure.duplicate(state, List.of(one), Vec3.X));
            case 3 -> model.editState(Label.of(Label.Edit.DELETE), now -> Structure.delete(state, List.of(one)));
            case 4 -> model.editState(Label.of(Label.Edit.COMBINE), now ->
                    Structure.combine(state, List.of(ScenePath.body(1), ScenePath.body(2)), Csg.Operation.UNION, ""));
            default -> model.edit(Label.of(Label.Edit.ADD), scene -> scene.plus(Light.at(random.nextDouble(), 5, 2)));
        }
    }

    /** With the whole picture there, which takes more than one in the making. */
    private static long usedAtRest(EditorGui editor) {
        editor.gui.until("the picture is complete", editor.editor::isPictureComplete);
        for (int i = 0; i < 3; i++) {
            System.gc();
        }
        return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
    }
}
