package cz.paprsek.fx.view.command;

import cz.paprsek.fx.model.Places;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Csg.Operation;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import java.util.function.Predicate;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import org.kordamp.ikonli.materialdesign2.MaterialDesignB;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignD;
import org.kordamp.ikonli.materialdesign2.MaterialDesignE;
import org.kordamp.ikonli.materialdesign2.MaterialDesignF;
import org.kordamp.ikonli.materialdesign2.MaterialDesignL;
import org.kordamp.ikonli.materialdesign2.MaterialDesignU;
import org.kordamp.ikonli.materialdesign2.MaterialDesignV;

/** What can be done with what is selected: the same words, keys and rules in every menu and view. */
public final class SelectionCommands {
    private final Edits edits;
    private final Command cut;
    private final Command copy;
    private final Command paste;
    private final Command duplicate;
    private final Command delete;
    private final Command rename;
    private final Command look;
    private final Command makeFirst;
    private final Command addCamera;
    private final Command soften;
    private final Command union;
    private final Command difference;
    private final Command intersection;
    private final Command group;
    private final Command dissolve;
    private final Command repeat;
    private final Command repeatRound;
    private final Command mirror;
    private final Command define;
    private final Command another;
    private final Command turntable;
    private final Command pivot;
    private final Command leaveOut;
    private final Command pipette;
    private final Command hide;
    private final Command showAll;
    private final Command lock;
    private final Command unlockAll;
    private final Command blink;
    private Runnable onRename = () -> {};
    private Runnable onBlink = () -> {};

    public SelectionCommands(Edits edits) {
        this.edits = edits;
        Predicate<Set<ScenePath>> any = items -> !items.isEmpty();
        Predicate<Set<ScenePath>> several = items -> Places.outermost(items).size() > 1;
        cut = command("edit-menu.cut", any, edits::cut).keys("Shortcut+X").icon(MaterialDesignC.CONTENT_CUT);
        copy = command("edit-menu.copy", any, edits::copy).keys("Shortcut+C").icon(MaterialDesignC.CONTENT_COPY);
        paste = command("edit-menu.paste", items -> true, edits::paste).keys("Shortcut+V").icon(MaterialDesignC.CONTENT_PASTE);
        duplicate = command("edit-menu.duplicate", any, edits::duplicate).keys("Shortcut+D").icon(MaterialDesignC.CONTENT_DUPLICATE);
        delete = command("edit-menu.delete", any, edits::delete).keys("Delete").icon(MaterialDesignD.DELETE_OUTLINE);
        rename = command("object.rename", items -> items.size() == 1, () -> onRename.run()).keys("F2")
                .icon(MaterialDesignF.FORM_TEXTBOX);
        Predicate<Set<ScenePath>> camera = items -> items.size() == 1 && !Places.cameras(items).isEmpty();
        look = command("object.look", camera, () -> selectedCamera(at -> edits.model().look(at)));
        makeFirst = command("object.first-camera", items -> camera.test(items) && !items.contains(ScenePath.camera()), () -> selectedCamera(edits::makeFirst));
        addCamera = command("view-menu.new-camera", items -> true, edits::addCamera);
        soften = command("object.soften", items -> true, edits::soften).keys("Shortcut+Shift+B").icon(MaterialDesignB.BOX_SHADOW);
        union = command("object.union", several, () -> edits.combine(Operation.UNION)).keys("Shortcut+Shift+U").icon(MaterialDesignV.VECTOR_UNION);
        difference = command("object.difference", several, () -> edits.combine(Operation.DIFFERENCE)).keys("Shortcut+Shift+D")
                .icon(MaterialDesignV.VECTOR_DIFFERENCE_AB);
        intersection = command("object.intersection", several, () -> edits.combine(Operation.INTERSECTION)).keys("Shortcut+Shift+I")
                .icon(MaterialDesignV.VECTOR_INTERSECTION);
        group = command("object.group", several, edits::group).keys("Shortcut+G");
        dissolve = command("object.dissolve", items -> !Places.bodies(items).isEmpty(), edits::dissolve).keys("Shortcut+Shift+G")
                .icon(MaterialDesignU.UNGROUP);
        Predicate<Set<ScenePath>> bodies = items -> !Places.bodies(items).isEmpty();
        repeat = command("object.repeat", bodies, () -> edits.repeat(false)).keys("Shortcut+Shift+R");
        repeatRound = command("object.repeat-round", bodies, () -> edits.repeat(true));
        mirror = command("object.mirror", bodies, edits::mirror);
        define = command("object.define", items -> items.size() == 1 && bodies.test(items), edits::define);
        another = Command.of("object.another", edits.texts(), edits::another).disabledIf(Bindings.createBooleanBinding(() -> edits.used().isEmpty(), edits.model().stateProperty()));
        turntable = command("object.turntable", bodies, edits::turntable);
        pivot = either(command("object.pivot", bodies, edits::pivot), edits::hasPivot, "object.pivot-middle");
        pipette = command("object.pipette", bodies, edits.pipette()::toggle).keys("Shortcut+Shift+P").icon(MaterialDesignE.EYEDROPPER);
        blink = command("object.blink", bodies, () -> onBlink.run()).keys("Shortcut+B");
        leaveOut = either(command("object.leave-out", bodies, edits::leaveOut), edits::isLeftOut, "object.take-in");
        hide = either(command("object.hide", any, edits::hideOrShow).keys("Shortcut+H").icon(MaterialDesignE.EYE_OFF_OUTLINE),
                edits::isHidden, "object.show");
        showAll = command("object.show-all", items -> true, edits::showAll).keys("Shortcut+Shift+H");
        lock = either(command("object.lock", any, edits::lockOrUnlock).keys("Shortcut+L").icon(MaterialDesignL.LOCK_OUTLINE),
                edits::isLocked, "object.unlock");
        unlockAll = command("object.unlock-all", items -> true, edits::unlockAll).keys("Shortcut+Shift+L");
    }

    /** Gives what is selected another name, where names are shown. */
    public void setOnRename(Runnable action) {
        onRename = action;
    }

    /** Shows what would be without what is selected. */
    public void setOnBlink(Runnable action) {
        onBlink = action;
    }

    public Edits edits() {
        return edits;
    }

    /** For buttons: copying beside, deleting; then the three operations. */
    public List<Command> forButtons() {
        return List.of(duplicate, delete, union, difference, intersection);
    }

    /** What makes all shadows softer, or those of the selected lights. */
    public Command soften() {
        return soften;
    }

    /** What makes the selection of the material of what is clicked next. */
    public Command pipette() {
        return pipette;
    }

    /** Cutting, copying, pasting, deleting. */
    public List<MenuItem> editItems() {
        return items(cut, copy, paste, duplicate, delete);
    }

    public List<MenuItem> selectingItems() {
        return items(command("edit-menu.select-all", items -> true, edits::selectAll).keys("Shortcut+A"),
                command("edit-menu.select-none", items -> true, () -> edits.model().select()).keys("Shortcut+Shift+A"));
    }

    private void selectedCamera(IntConsumer action) {
        Places.cameras(edits.model().selection()).stream().findFirst().ifPresent(camera -> action.accept(camera.index()));
    }

    /** Names, operations, lights and cameras, hiding and locking. */
    public List<MenuItem> objectItems() {
        List<MenuItem> items = new ArrayList<>(items(rename, union, difference, intersection, group, dissolve, repeat, repeatRound, mirror, define, another, turntable, pivot, pipette));
        items.add(new ArrangeCommands(edits).menu());
        items.addAll(new ArrangeCommands(edits).operandItems());
        items.add(new SeparatorMenuItem());
        items.addAll(new ArrangeCommands(edits).lightItems());
        items.addAll(items(soften, look, makeFirst, addCamera));
        items.add(new SeparatorMenuItem());
        items.addAll(items(blink, leaveOut, hide, showAll, lock, unlockAll));
        return items;
    }

    /** All of it, for a click of the right button. */
    public ContextMenu contextMenu() {
        ContextMenu menu = new ContextMenu();
        menu.setAutoHide(true);
        menu.getItems().addAll(editItems());
        menu.getItems().add(new SeparatorMenuItem());
        menu.getItems().addAll(objectItems());
        return menu;
    }

    private static List<MenuItem> items(Command... commands) {
        return List.of(commands).stream().map(Command::menuItem).toList();
    }

    private Command command(String key, Predicate<Set<ScenePath>> possible, Runnable action) {
        return Command.of(key, edits.texts(), action).disabledIf(unless(possible));
    }

    /** Called otherwise as long as it would do the opposite. */
    private Command either(Command command, BooleanSupplier opposite, String otherKey) {
        return command.called(Bindings.createStringBinding(
                () -> edits.texts().of(opposite.getAsBoolean() ? otherKey : command.key()), edits.model().stateProperty()));
    }

    private BooleanBinding unless(Predicate<Set<ScenePath>> condition) {
        return Bindings.createBooleanBinding(() -> !condition.test(edits.model().selection()), edits.model().selectionProperty());
    }
}
