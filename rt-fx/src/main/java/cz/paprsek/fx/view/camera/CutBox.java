package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.model.edit.CutPlane;
import java.util.Locale;
import java.util.Optional;
import javafx.beans.binding.Bindings;
import javafx.beans.property.ObjectProperty;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;

/** Moves the plane that solids are cut open by, above a picture; only there while there is one. */
final class CutBox extends HBox {
    private static final double WIDTH = 110;

    CutBox(ObjectProperty<Optional<CutPlane>> plane) {
        super(4);
        getStyleClass().add("picture-size");
        setAlignment(Pos.CENTER);
        setMaxSize(Region.USE_PREF_SIZE, Region.USE_PREF_SIZE);
        Label axis = new Label();
        axis.textProperty().bind(Bindings.createStringBinding(() -> plane.get().map(known -> known.axis().name().toLowerCase(Locale.ROOT)).orElse(""), plane));
        Slider slider = new Slider(0, 1, 0.5);
        slider.getStyleClass().add("cut-slider");
        slider.setPrefWidth(WIDTH);
        slider.setFocusTraversable(false);
        slider.valueProperty().addListener((property, old, now) -> plane.get().filter(known -> known.share() != now.doubleValue())
                .ifPresent(known -> plane.set(Optional.of(new CutPlane(known.axis(), now.doubleValue())))));
        plane.addListener((property, old, now) -> show(plane, slider));
        show(plane, slider);
        getChildren().addAll(axis, slider);
    }

    private void show(ObjectProperty<Optional<CutPlane>> plane, Slider slider) {
        setVisible(plane.get().isPresent());
        plane.get().ifPresent(known -> slider.setValue(known.share()));
    }
}
