package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Alignment;
import cz.paprsek.fx.model.edit.Cameras;
import cz.paprsek.fx.model.edit.Looks;
import cz.paprsek.fx.model.edit.Looks.Side;
import cz.paprsek.fx.view.command.Command;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Camera.Target;
import cz.paprsek.scene.ScenePath;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;

/** What is done with the free view: the same words in the menu and in its title. */
public final class FreeCommands {
    private final EditorModel model;
    private final Edits edits;
    private final CameraPane pane;
    private final Runnable onUsed;
    private final Runnable onLocked;

    /**
     * @param onUsed shows the free view, if it is not there
     * @param onLocked is told if the scene's camera should move, but is locked
     */
    public FreeCommands(Edits edits, CameraPane pane, Runnable onUsed, Runnable onLocked) {
        this.edits = edits;
        this.model = edits.model();
        this.pane = pane;
        this.onUsed = onUsed;
        this.onLocked = onLocked;
    }

    /** Fresh menu items, to be put somewhere. */
    public List<MenuItem> items() {
        List<MenuItem> items = new ArrayList<>();
        items.add(command("free.from-camera", () -> pane.look(old -> model.state().camera())).menuItem());
        items.add(Command.of("free.to-camera", edits.texts(), this::toCamera).menuItem());
        items.add(new SeparatorMenuItem());
        items.add(command("free.selection", () -> pane.look(old -> Looks.at(box(), old))).menuItem());
        items.add(new SeparatorMenuItem());
        for (Side side : Side.values()) {
            items.add(command("free." + side.name().toLowerCase(Locale.ROOT), () -> pane.look(old -> Looks.from(side, old, pivot(old)))).menuItem());
        }
        return items;
    }

    private Command command(String key, Runnable action) {
        return Command.of(key, edits.texts(), () -> {
            onUsed.run();
            action.run();
        });
    }

    /** The scene's camera then sees what the free view does. */
    private void toCamera() {
        int eye = model.state().eye();
        if (model.state().isLocked(ScenePath.camera(eye))) {
            onLocked.run();
            return;
        }
        Camera seen = pane.camera();
        model.edit(Label.of(Label.Edit.CAMERA), scene -> Cameras.changed(scene, eye, old -> seen.named(old.name())));
    }

    /** Of what is selected, or of everything. */
    private Bounds box() {
        Bounds selected = Alignment.around(model.state(), model.selection());
        return selected.isEmpty() ? all() : selected;
    }

    private Bounds all() {
        return Alignment.with(model.state(), List.of()).others().stream().reduce(Bounds.EMPTY, Bounds::union);
    }

    private Vec3 pivot(Camera camera) {
        if (camera.aim() instanceof Target target) {
            return target.point();
        }
        Bounds all = all();
        return all.isEmpty() ? Vec3.ZERO : all.middle();
    }
}
