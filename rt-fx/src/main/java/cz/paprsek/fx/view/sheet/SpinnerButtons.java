package cz.paprsek.fx.view.sheet;

import javafx.animation.Animation;
import javafx.animation.KeyFrame;
import javafx.animation.Timeline;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.util.Duration;
import org.kordamp.ikonli.javafx.FontIcon;

/** Two arrows that step a number for as long as they are pressed, which is one step of the history. */
final class SpinnerButtons extends VBox {
    private static final Duration PATIENCE = Duration.millis(400);
    private static final Duration PACE = Duration.millis(60);

    private final NumberField field;
    private final Timeline repeat = new Timeline();
    private double steps;

    SpinnerButtons(NumberField field) {
        this.field = field;
        getStyleClass().add("spinner-buttons");
        getChildren().addAll(arrow("mdi2c-chevron-up", 1), arrow("mdi2c-chevron-down", -1));
    }

    private Region arrow(String icon, double step) {
        VBox button = new VBox(new FontIcon(icon));
        button.getStyleClass().add(step > 0 ? "step-up" : "step-down");
        button.addEventHandler(MouseEvent.MOUSE_PRESSED, event -> {
            field.begin();
            steps = 0;
            double by = step * Steps.factor(event);
            advance(by);
            repeat.getKeyFrames().setAll(new KeyFrame(PACE, e -> advance(by)));
            repeat.setCycleCount(Animation.INDEFINITE);
            repeat.setDelay(PATIENCE);
            repeat.playFromStart();
            event.consume();
        });
        button.addEventHandler(MouseEvent.MOUSE_RELEASED, event -> {
            repeat.stop();
            field.commit();
        });
        return button;
    }

    private void advance(double by) {
        steps += by;
        field.step(steps);
    }
}
