package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.edit.Materials;
import cz.paprsek.fx.model.property.Property;
import cz.paprsek.fx.view.command.Command;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Mesh;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.javafx.FontIcon;

/** Where the material of what is selected comes from: its own, one of the scene's named ones, one that every scene knows, or from above. */
final class MaterialEditor implements PropertyEditor {
    /** A material of an object's own, whatever it is like. */
    private enum Own { OWN }

    private final EditorModel model;
    private final Texts texts;
    private final PropertyEdit edit;
    private final Property property;
    private final List<BodyAt> places;
    private final ChoiceEditor<Object> choice;
    private final TextEditor name;
    private final Label shared = new Label();
    private final Button share;
    private final HBox naming;
    private final HBox buttons = new HBox(2);
    private final VBox box = new VBox();

    MaterialEditor(EditorModel model, PropertyEdit edit, Texts texts, Property property, Optional<Command> pipette) {
        this.model = model;
        this.edit = edit;
        this.texts = texts;
        this.property = property;
        places = Places.bodies(model.selection());
        choice = new ChoiceEditor<>("material", texts.of("sheet.mixed"), this::text, this::options, this::chosen, this::choose);
        name = new TextEditor("material-name", edit, scene -> named(scene).orElse(""),
                (scene, fresh) -> named(scene).map(old -> Materials.rename(scene, old, fresh)).orElse(scene));
        share = new Button("", new FontIcon("mdi2t-tag-plus-outline"));
        share.setId("material-share");
        Hint.of(share).set(texts.of("material.share"));
        share.setAccessibleText(texts.of("material.share"));
        share.getStyleClass().add("small-button");
        share.setOnAction(event -> edit.change(scene -> Materials.name(scene, places, texts.of("material.new"))));
        pipette.map(Command::button).ifPresent(button -> {
            button.getStyleClass().add("small-button");
            button.setFocusTraversable(true);
            buttons.getChildren().add(button);
        });
        buttons.getChildren().add(share);
        shared.getStyleClass().add("hint");
        shared.setWrapText(true);
        box.getStyleClass().add("material-editor");
        Label caption = new Label(texts.of("field.name"));
        caption.setLabelFor(name.node());
        caption.setMinWidth(Region.USE_PREF_SIZE);
        naming = new HBox(8, caption, name.node());
        naming.setAlignment(Pos.CENTER_LEFT);
        HBox.setHgrow(name.node(), Priority.ALWAYS);
        box.getChildren().addAll(choice.node(), naming, shared);
    }

    @Override
    public Node node() {
        return box;
    }

    /** What can be done with the material. */
    Node buttons() {
        return buttons;
    }

    @Override
    public void show(Scene scene) {
        choice.show(scene);
        name.show(scene);
        Optional<String> named = named(scene);
        setShown(naming, named.isPresent());
        setShown(shared, named.isPresent());
        named.ifPresent(known -> shared.setText(texts.of("material.uses", Materials.uses(scene, known))));
        share.setDisable(property.target().read(scene).isEmpty() || !chosen(scene).equals(Optional.of(Own.OWN)));
    }

    private static void setShown(Node node, boolean shown) {
        node.setVisible(shown);
        node.setManaged(shown);
    }

    private String text(Object option) {
        if (option instanceof MaterialName named) {
            return named.name();
        }
        boolean operands = places.stream().allMatch(at -> at.depth() > 0);
        return texts.of(option == Own.OWN ? "material.own" : operands ? "material.inherited" : haveFiles() ? "material.of-file" : "material.none");
    }

    /** Whether what is selected are meshes that are made of what their files say. */
    private boolean haveFiles() {
        return places.stream().map(at -> at.find(model.scene())).allMatch(body -> body.isPresent() && body.get().shape() instanceof Mesh mesh && !mesh.materials().isEmpty());
    }

    private List<Object> options(Scene scene) {
        List<Object> options = new ArrayList<>(List.of(Inherited.INHERITED, Own.OWN));
        scene.materials().keySet().forEach(known -> options.add(new MaterialName(known)));
        Material.ready().keySet().stream().filter(known -> !scene.materials().containsKey(known)).map(MaterialName::new).forEach(options::add);
        return options;
    }

    private Optional<Object> chosen(Scene scene) {
        Set<Object> sources = new HashSet<>();
        for (BodyAt at : places) {
            at.find(scene).ifPresent(body ->
                    sources.add(body.material() instanceof Material ? Own.OWN : body.material()));
        }
        return sources.size() == 1 ? Optional.of(sources.iterator().next()) : Optional.empty();
    }

    private Optional<String> named(Scene scene) {
        return chosen(scene).flatMap(source -> source instanceof MaterialName named && scene.materials().containsKey(named.name()) ? Optional.of(named.name()) : Optional.empty());
    }

    private void choose(Object option) {
        boolean accepted = edit.change(scene -> option == Own.OWN ? Materials.own(scene, places)
                : property.write(scene, option));
        if (!accepted) {
            choice.show(model.scene());
        }
    }
}
