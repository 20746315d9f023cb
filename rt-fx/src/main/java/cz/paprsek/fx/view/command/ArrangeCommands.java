package cz.paprsek.fx.view.command;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.contact.Falling;
import cz.paprsek.fx.model.edit.Arranging;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.fx.model.edit.Arranging.Side;
import cz.paprsek.scene.ScenePath;
import java.util.List;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javafx.beans.binding.Bindings;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;

/** What puts bodies in line, on the floor and in their roles: a menu within that of objects. */
final class ArrangeCommands {
    private final Edits edits;

    ArrangeCommands(Edits edits) {
        this.edits = edits;
    }

    Menu menu() {
        Menu menu = new Menu(edits.texts().of("arrange.menu"));
        menu.setId("object-arrange");
        Predicate<Set<ScenePath>> any = items -> !Places.bodies(items).isEmpty();
        Predicate<Set<ScenePath>> several = items -> Places.outermost(items).size() > 1;
        Predicate<Set<ScenePath>> many = items -> Places.outermost(items).size() > 2;
        menu.getItems().add(command("arrange.floor", any, Edit.MOVE, Falling::onFloor).keys("Shortcut+Shift+Down").menuItem());
        menu.getItems().add(new SeparatorMenuItem());
        menu.getItems().addAll(Stream.of(
                aligned("arrange.x-least", several, Axis.X, Side.LEAST), aligned("arrange.x-middle", several, Axis.X, Side.MIDDLE), aligned("arrange.x-most", several, Axis.X, Side.MOST),
                aligned("arrange.y-least", several, Axis.Y, Side.LEAST), aligned("arrange.y-middle", several, Axis.Y, Side.MIDDLE), aligned("arrange.y-most", several, Axis.Y, Side.MOST),
                aligned("arrange.z-least", several, Axis.Z, Side.LEAST), aligned("arrange.z-middle", several, Axis.Z, Side.MIDDLE), aligned("arrange.z-most", several, Axis.Z, Side.MOST))
                .map(Command::menuItem).toList());
        menu.getItems().add(new SeparatorMenuItem());
        menu.getItems().addAll(Stream.of(distributed("arrange.spread-x", many, Axis.X), distributed("arrange.spread-y", many, Axis.Y), distributed("arrange.spread-z", many, Axis.Z))
                .map(Command::menuItem).toList());
        return menu;
    }

    /** What is done with operands. */
    List<MenuItem> operandItems() {
        Predicate<Set<ScenePath>> one = items -> items.size() == 1 && Places.bodies(items).stream()
                .anyMatch(at -> (at.index() > 0 && at.depth() > 0) || at.find(edits.model().scene()).filter(body -> body.operands().size() > 1).isPresent());
        Predicate<Set<ScenePath>> operands = items -> Places.bodies(items).stream().anyMatch(at -> at.depth() > 0);
        return Stream.of(command("arrange.base", one, Edit.REORDER, Arranging::base), command("arrange.solo", operands, Edit.HIDE, Arranging::solo)).map(Command::menuItem).toList();
    }

    /** What is done with lights. */
    List<MenuItem> lightItems() {
        Predicate<Set<ScenePath>> some = items -> !Places.lights(items).isEmpty() && Places.lights(items).size() < edits.model().scene().lights().size();
        return List.of(command("arrange.lights-alone", some, Edit.HIDE, Arranging::lightsAlone).keys("Shortcut+Shift+J").menuItem());
    }

    private Command aligned(String key, Predicate<Set<ScenePath>> possible, Axis axis, Side side) {
        return command(key, possible, Edit.MOVE, (state, items) -> Arranging.aligned(state, items, axis, side));
    }

    private Command distributed(String key, Predicate<Set<ScenePath>> possible, Axis axis) {
        return command(key, possible, Edit.MOVE, (state, items) -> Arranging.distributed(state, items, axis));
    }

    private Command command(String key, Predicate<Set<ScenePath>> possible, Edit edit, BiFunction<EditorState, Set<ScenePath>, EditorState> arranging) {
        return Command.of(key, edits.texts(), () -> edits.arrange(edit, arranging))
                .disabledIf(Bindings.createBooleanBinding(() -> !possible.test(edits.model().selection()), edits.model().selectionProperty()));
    }
}
