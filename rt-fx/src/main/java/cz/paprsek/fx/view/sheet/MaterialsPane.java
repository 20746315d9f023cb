package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.edit.Materials;
import cz.paprsek.fx.model.property.Section;
import cz.paprsek.fx.model.property.Sections;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.TitledPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.javafx.FontIcon;

/** The scene's named materials: one of them, chosen by name, with its properties. */
final class MaterialsPane extends TitledPane {
    private final EditorModel model;
    private final Texts texts;
    private final Editors editors;
    private final PropertyEdit edit;
    private final ChoiceEditor<String> choice;
    private final TextEditor name;
    private final SheetRow nameRow;
    private final Label uses = new Label();
    private final Button delete;
    private final VBox properties = new VBox();
    private final List<PropertyEditor> shown = new ArrayList<>();
    private final List<KeyButton> keys = new ArrayList<>();
    private Optional<String> chosen = Optional.empty();
    private Optional<Section> section = Optional.empty();

    MaterialsPane(EditorModel model, Texts texts, Editors editors) {
        this.model = model;
        this.texts = texts;
        this.editors = editors;
        setText(texts.of("section.materials"));
        setAnimated(false);
        getStyleClass().add("sheet-section");
        SheetRow row = new SheetRow(texts.of("material.named"));
        nameRow = new SheetRow(texts.of("field.name"));
        edit = new PropertyEdit(model, texts.of("field.material"), refusal -> nameRow.show(refusal.map(texts::sentence)));
        choice = new ChoiceEditor<>("materials", texts.of("material.empty"), option -> option,
                scene -> List.copyOf(scene.materials().keySet()), scene -> chosen, this::choose);
        name = new TextEditor("materials-name", edit, scene -> chosen.orElse(""), this::renamed);
        delete = button("materials-delete", "mdi2d-delete-outline", "material.delete", () -> chosen.ifPresent(old ->
                edit.change(scene -> Materials.delete(scene, old))));
        Button add = button("materials-add", "mdi2p-plus", "material.add", this::add);
        uses.getStyleClass().add("hint");
        properties.getStyleClass().add("sheet-rows");
        VBox rows = new VBox(row.below(choice.node(), new HBox(add, delete)), nameRow.beside(name.node()), uses, properties);
        rows.getStyleClass().add("sheet-rows");
        setContent(rows);
    }

    void show(Scene scene) {
        if (chosen.filter(scene.materials()::containsKey).isEmpty()) {
            chosen = scene.materials().keySet().stream().findFirst();
        }
        choice.show(scene);
        name.show(scene);
        delete.setDisable(chosen.isEmpty());
        setShown(nameRow, chosen.isPresent());
        setShown(uses, chosen.isPresent());
        chosen.ifPresent(known -> uses.setText(texts.of("material.uses", Materials.uses(scene, known))));
        Optional<Section> now = chosen.map(known -> Sections.material(scene, known));
        if (!now.equals(section)) {
            section = now;
            rebuild();
        }
        shown.forEach(editor -> editor.show(scene));
        showKeys(scene);
    }

    /** Shows which attributes have keys at the time that is looked at. */
    void showKeys(Scene scene) {
        keys.forEach(key -> key.show(scene));
    }

    private void rebuild() {
        properties.getChildren().clear();
        shown.clear();
        keys.clear();
        section.ifPresent(known -> known.properties().stream().map(editors::entry).forEach(entry -> {
            properties.getChildren().add(entry.row());
            shown.add(entry.editor());
            entry.key().ifPresent(keys::add);
        }));
    }

    private void choose(String option) {
        chosen = Optional.of(option);
        show(model.scene());
    }

    private void add() {
        List<String> before = List.copyOf(model.scene().materials().keySet());
        if (edit.change(scene -> Materials.add(scene, texts.of("material.new"), Material.DEFAULT))) {
            model.scene().materials().keySet().stream().filter(known -> !before.contains(known)).forEach(this::choose);
        }
    }

    private Scene renamed(Scene scene, String fresh) {
        Optional<String> old = chosen;
        Scene result = old.map(known -> Materials.rename(scene, known, fresh)).orElse(scene);
        chosen = Optional.of(fresh);
        return result;
    }

    private Button button(String id, String icon, String key, Runnable action) {
        Button button = new Button("", new FontIcon(icon));
        button.setId(id);
        button.setAccessibleText(texts.of(key));
        Hint.of(button).set(texts.of(key));
        button.getStyleClass().add("small-button");
        button.setOnAction(event -> action.run());
        return button;
    }

    private static void setShown(Node node, boolean isShown) {
        node.setVisible(isShown);
        node.setManaged(isShown);
    }
}
