package cz.paprsek.fx.view.sheet;

import cz.paprsek.scene.Scene;
import javafx.scene.Node;

/** Shows one property and lets it be changed. */
interface PropertyEditor {

    /** What is put into the sheet. */
    Node node();

    /** Shows the property as it is in a scene. */
    void show(Scene scene);
}
