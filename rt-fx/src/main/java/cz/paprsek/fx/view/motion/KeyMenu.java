package cz.paprsek.fx.view.motion;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.model.motion.Keys;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.MaterialName;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe.Parameter;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.MaterialAt;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignP;

/** What gives what is selected a key at the time that is looked at: for each of its attributes, with the value as it is written, or as it is at the time. */
final class KeyMenu {
    private final EditorModel model;
    private final Edits edits;
    private final Texts texts;
    private final Clock clock;

    KeyMenu(Edits edits, Clock clock) {
        this.model = edits.model();
        this.edits = edits;
        this.texts = edits.texts();
        this.clock = clock;
    }

    MenuButton button() {
        MenuButton button = new MenuButton(texts.of("timeline.add"), new FontIcon(MaterialDesignP.PLUS));
        button.setId("timeline-add");
        button.getStyleClass().add("view-button");
        Hint.of(button).set(texts.of("timeline.add-hint"));
        button.setFocusTraversable(false);
        button.getItems().add(new MenuItem());
        button.setOnShowing(event -> button.getItems().setAll(items()));
        return button;
    }

    private List<MenuItem> items() {
        Scene scene = model.scene();
        Set<ScenePath> places = new LinkedHashSet<>(model.selection());
        for (ScenePath place : model.selection()) {
            if (place instanceof BodyAt at && at.in(scene).material() instanceof MaterialName name && scene.materials().containsKey(name.name())) {
                places.add(new MaterialAt(name.name()));
            }
        }
        if (places.isEmpty()) {
            places.add(ScenePath.camera(model.state().eye()));
            scene.materials().keySet().forEach(name -> places.add(new MaterialAt(name)));
        }
        List<MenuItem> items = new ArrayList<>();
        for (ScenePath place : places) {
            List<MenuItem> own = items(scene, place);
            if (places.size() == 1 && !own.isEmpty()) {
                items.addAll(own);
            } else if (!own.isEmpty()) {
                Menu menu = new Menu(name(scene, place));
                menu.setMnemonicParsing(false);
                menu.getItems().setAll(own);
                items.add(menu);
            }
        }
        if (model.selection().isEmpty()) {
            scene.recipe().parameters().forEach(parameter -> items.add(item(parameter)));
        }
        return items;
    }

    private String name(Scene scene, ScenePath place) {
        return place instanceof MaterialAt at ? at.name() : PathNames.of(scene, place, texts);
    }

    private List<MenuItem> items(Scene scene, ScenePath place) {
        Scene moment = clock.shown().scene();
        Map<String, String> now = place.isIn(moment) ? Animation.values(moment, place) : Map.of();
        List<MenuItem> items = new ArrayList<>();
        Animation.values(scene, place).forEach((attribute, written) -> {
            items.add(item(place, attribute, written));
            Optional.ofNullable(now.get(attribute)).filter(value -> !value.equals(written)).ifPresent(value -> items.add(item(place, attribute, value)));
        });
        return items;
    }

    private MenuItem item(ScenePath place, String attribute, String value) {
        MenuItem item = new MenuItem(texts.of("timeline.add-value", texts.attribute(attribute), texts.number(value)));
        item.setId("timeline-add-" + attribute);
        item.setMnemonicParsing(false);
        item.setOnAction(event -> edits.attempt(() -> model.edit(label(name(model.scene(), place) + ": " + texts.attribute(attribute)),
                scene -> Keys.added(scene, place, attribute, clock.time(), value))));
        return item;
    }

    private MenuItem item(Parameter parameter) {
        MenuItem item = new MenuItem(texts.of("timeline.add-value", parameter.name(), texts.number(parameter.value())));
        item.setId("timeline-add-" + parameter.name());
        item.setMnemonicParsing(false);
        item.setOnAction(event -> edits.attempt(() -> model.edit(label(parameter.name()), now -> Keys.added(now, parameter.name(), clock.time(), parameter.value()))));
        return item;
    }

    private Label label(String name) {
        return Label.of(Edit.CHANGE, texts.of("timeline.keys-of", name));
    }
}
