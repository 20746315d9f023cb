package cz.paprsek.fx.view.dialog;

import cz.paprsek.fx.view.texts.Texts;
import java.util.Optional;
import javafx.application.Platform;
import javafx.event.ActionEvent;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.ButtonBar.ButtonData;
import javafx.scene.control.ButtonType;
import javafx.scene.control.ColorPicker;
import javafx.scene.control.ComboBoxBase;
import javafx.scene.control.Dialog;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Tooltip;
import javafx.scene.paint.Color;
import javafx.scene.shape.Rectangle;
import javafx.stage.PopupWindow;
import javafx.stage.Window;

/**
 * A colour out of a palette, or any other in a dialog of our own: that of JavaFX is modal in the way that {@link Deaf} avoids, and has no words in Czech, as those over
 * the colours of its palette, which are replaced, too.
 */
public final class ColorBox extends ColorPicker {
    private final Texts texts;

    public ColorBox(Texts texts) {
        super(Color.WHITE);
        this.texts = texts;
        // Its text would be a name in English, or a number as no file has it.
        setStyle("-fx-color-label-visible: false");
        addEventHandler(ComboBoxBase.ON_SHOWN, event -> Window.getWindows().forEach(window -> {
            if (window instanceof PopupWindow && window.getScene().lookup(".color-palette .hyperlink") instanceof Hyperlink other) {
                other.setText(texts.of("color.other"));
                other.setOnAction(clicked -> {
                    hide();
                    ask();
                });
                window.getScene().getRoot().lookupAll(".color-square").forEach(this::name);
                hideFrame(window.getScene().getRoot());
            }
        }));
    }

    /** Says over a colour of the palette what it is called. */
    private void name(Node square) {
        fill(square).ifPresent(color -> Tooltip.install(square, new Tooltip(ColorNames.of(color, texts))));
    }

    /** Shows no frame about a chosen colour that the palette does not have: JavaFX puts it at the corner. */
    private void hideFrame(Parent palette) {
        if (palette.lookupAll(".color-square").stream().noneMatch(square -> fill(square).filter(getValue()::equals).isPresent())) {
            palette.lookupAll(".hover-square").forEach(frame -> frame.setVisible(false));
        }
    }

    private static Optional<Color> fill(Node square) {
        return ((Parent) square).getChildrenUnmodifiable().stream().filter(Rectangle.class::isInstance).map(rectangle -> ((Rectangle) rectangle).getFill())
                .filter(Color.class::isInstance).map(Color.class::cast).findFirst();
    }

    private void ask() {
        ButtonType take = new ButtonType(texts.of("color.take"), ButtonData.OK_DONE);
        ColorForm form = new ColorForm(getValue(), texts);
        Dialog<ButtonType> dialog = new Dialog<>();
        dialog.setTitle(texts.of("color.title"));
        dialog.getDialogPane().getButtonTypes().setAll(take, new ButtonType(texts.of("color.leave"), ButtonData.CANCEL_CLOSE));
        dialog.getDialogPane().setContent(form);
        dialog.getDialogPane().lookupButton(take).disableProperty().bind(form.refused());
        // Once it is open.
        Platform.runLater(form::takeKeys);
        if (Deaf.ask(dialog, getScene().getWindow()).filter(take::equals).isPresent() && form.isChanged()) {
            setValue(form.color());
            fireEvent(new ActionEvent());
        }
    }
}
