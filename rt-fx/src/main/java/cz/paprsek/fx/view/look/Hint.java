package cz.paprsek.fx.view.look;

import javafx.beans.property.ObjectProperty;
import javafx.event.EventHandler;
import javafx.scene.control.Control;
import javafx.scene.control.Tooltip;
import javafx.scene.input.MouseEvent;

/**
 * What a control is for, told when the mouse rests on it, and to who hears rather than sees. JavaFX's tooltip is a window of its own, whose styles are searched for anew:
 * it is made when the mouse first comes, since an editor has hundreds, most of which nobody ever reads.
 */
public final class Hint {
    private static final EventHandler<MouseEvent> MOUSE_COMES = event -> {
        if (event.getSource() instanceof Control control && control.getTooltip() == null) {
            Tooltip tooltip = new Tooltip();
            tooltip.textProperty().bind(control.accessibleHelpProperty());
            control.setTooltip(tooltip);
        }
    };

    private Hint() {}

    /** The hint of a control, to be set or bound. */
    public static ObjectProperty<String> of(Control control) {
        control.addEventHandler(MouseEvent.MOUSE_ENTERED, MOUSE_COMES);
        return control.accessibleHelpProperty();
    }
}
