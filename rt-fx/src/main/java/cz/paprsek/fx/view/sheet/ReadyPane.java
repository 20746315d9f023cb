package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.edit.Materials;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.look.MaterialBalls;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.xml.SceneFiles;
import java.util.List;
import java.util.Optional;
import javafx.scene.control.Button;
import javafx.scene.control.TitledPane;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.input.ClipboardContent;
import javafx.scene.input.Dragboard;
import javafx.scene.input.TransferMode;
import javafx.scene.layout.FlowPane;

/** The materials that every scene knows, each as a ball: a click makes what is selected of it, and it can be dropped on any body. */
final class ReadyPane extends TitledPane {
    private final EditorModel model;
    private final PropertyEdit edit;
    private final FlowPane balls = new FlowPane(2, 2);

    ReadyPane(EditorModel model, Texts texts) {
        this.model = model;
        edit = new PropertyEdit(model, texts.of("field.material"), refusal -> {});
        setId("ready-materials");
        setText(texts.of("section.ready"));
        setAnimated(false);
        setExpanded(false);
        getStyleClass().add("sheet-section");
        setContent(balls);
        expandedProperty().addListener((property, was, is) -> fill());
    }

    /** Balls are made when somebody wants to see them. */
    private void fill() {
        if (isExpanded() && balls.getChildren().isEmpty()) {
            Material.ready().forEach((name, material) -> balls.getChildren().add(ball(name, material)));
            MaterialBalls.paint(Material.ready(), (name, image) -> balls.getChildren().stream().filter(node -> node.getId().equals(id(name)))
                    .forEach(node -> ((ImageView) ((Button) node).getGraphic()).setImage(image)));
        }
    }

    private static String id(String name) {
        return "ready-" + name;
    }

    private Button ball(String name, Material material) {
        ImageView picture = new ImageView();
        picture.setFitWidth(MaterialBalls.SIZE);
        picture.setFitHeight(MaterialBalls.SIZE);
        Button button = new Button("", picture);
        button.setId(id(name));
        button.setAccessibleText(name);
        Hint.of(button).set(name);
        button.getStyleClass().addAll("small-button", "ready-ball");
        button.setOnAction(event -> give(name, material));
        button.setOnDragDetected(event -> {
            drag(button, Scene.EMPTY.plus(name, material), Optional.ofNullable(picture.getImage()));
            event.consume();
        });
        return button;
    }

    private void give(String name, Material material) {
        List<BodyAt> bodies = Places.bodies(model.selection());
        if (!bodies.isEmpty()) {
            edit.change(scene -> Materials.give(scene, bodies, name, material));
        }
    }

    /** As the text of a scene that has it and nothing else, as out of the library. */
    private static void drag(Button from, Scene scene, Optional<Image> picture) {
        ClipboardContent content = new ClipboardContent();
        content.putString(SceneFiles.format(scene));
        Dragboard board = from.startDragAndDrop(TransferMode.COPY);
        board.setContent(content);
        picture.ifPresent(board::setDragView);
    }
}
