package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import javafx.beans.property.ObjectProperty;
import javafx.geometry.Insets;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;
import org.kordamp.ikonli.materialdesign2.MaterialDesignR;

/** Three buttons above a picture: what the handles in it do. */
final class ModeBox extends VBox {
    private static final Map<Handles.Mode, Ikon> ICONS =
            Map.of(Handles.Mode.MOVE, MaterialDesignA.ARROW_ALL, Handles.Mode.TURN, MaterialDesignR.ROTATE_3D_VARIANT, Handles.Mode.SCALE, MaterialDesignR.RESIZE);

    ModeBox(Texts texts, ObjectProperty<Handles.Mode> mode) {
        getStyleClass().add("handle-modes");
        setMaxSize(Region.USE_PREF_SIZE, Region.USE_PREF_SIZE);
        setPickOnBounds(false);
        StackPane.setMargin(this, new Insets(4));
        Map<Handles.Mode, ToggleButton> buttons = new EnumMap<>(Handles.Mode.class);
        for (Handles.Mode value : Handles.Mode.values()) {
            String name = value.name().toLowerCase(Locale.ROOT);
            ToggleButton button = new ToggleButton("", new FontIcon(ICONS.getOrDefault(value, MaterialDesignA.ARROW_ALL)));
            button.setId("handles-" + name);
            Hint.of(button).set(texts.of("handles." + name));
            button.setAccessibleText(texts.of("handles." + name));
            button.setFocusTraversable(false);
            button.setSelected(value == mode.get());
            button.setOnAction(event -> {
                mode.set(value);
                button.setSelected(true);
            });
            buttons.put(value, button);
            getChildren().add(button);
        }
        mode.addListener((property, old, now) -> buttons.forEach((value, button) -> button.setSelected(value == now)));
    }
}
