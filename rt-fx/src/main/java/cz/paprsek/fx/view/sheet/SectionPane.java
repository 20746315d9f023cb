package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.property.Section;
import cz.paprsek.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import javafx.scene.control.TitledPane;
import javafx.scene.layout.VBox;

/** A heading with the properties under it. */
final class SectionPane extends TitledPane {
    private final List<PropertyEditor> editors = new ArrayList<>();
    private final VBox rows = new VBox();

    SectionPane(String title, Section section, Editors factory) {
        setText(title);
        setAnimated(false);
        getStyleClass().add("sheet-section");
        rows.getStyleClass().add("sheet-rows");
        section.properties().stream().map(factory::entry).forEach(entry -> {
            rows.getChildren().add(entry.row());
            editors.add(entry.editor());
        });
        setContent(rows);
    }

    void show(Scene scene) {
        editors.forEach(editor -> editor.show(scene));
    }
}
