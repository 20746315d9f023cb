package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.texts.Texts;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.collections.ListChangeListener;
import javafx.geometry.Pos;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import javafx.scene.layout.HBox;
import javafx.util.StringConverter;

/** Chooses which other render is laid over the one that is shown. */
final class ComparisonBox extends HBox {
    private final TabPane tabs;
    private final ComboBox<Optional<RenderTab>> box = new ComboBox<>();

    ComparisonBox(TabPane tabs, Texts texts) {
        super(6);
        this.tabs = tabs;
        box.setId("render-compare");
        box.setConverter(new StringConverter<>() {
            @Override
            public String toString(Optional<RenderTab> tab) {
                return tab == null ? "" : tab.map(Tab::getText).orElse("–");
            }

            @Override
            public Optional<RenderTab> fromString(String text) {
                return Optional.empty();
            }
        });
        setAlignment(Pos.CENTER_LEFT);
        getChildren().addAll(new Label(texts.of("render.compare")), box);
        tabs.getTabs().addListener((ListChangeListener<Tab>) change -> offer());
        tabs.getSelectionModel().selectedItemProperty().addListener((property, old, now) -> offer());
        box.valueProperty().addListener((property, old, now) -> compare());
        offer();
    }

    /** Offers all renders but the one shown; every tab remembers what it is compared with. */
    private void offer() {
        List<Optional<RenderTab>> choices = new ArrayList<>();
        choices.add(Optional.empty());
        tabs.getTabs().stream().map(RenderTab.class::cast).filter(tab -> tab != tabs.getSelectionModel().getSelectedItem())
                .forEach(tab -> choices.add(Optional.of(tab)));
        Optional<RenderTab> wanted = shown().flatMap(RenderTab::comparedWith).filter(tab -> tabs.getTabs().contains(tab));
        // Else the box would go on counting from where the value stood in the old list.
        box.getSelectionModel().clearSelection();
        box.getItems().setAll(choices);
        box.getSelectionModel().select(wanted);
        box.setDisable(choices.size() == 1);
    }

    private void compare() {
        Optional<RenderTab> chosen = box.getValue();
        if (chosen != null) {
            shown().ifPresent(tab -> tab.compareWith(chosen));
        }
    }

    private Optional<RenderTab> shown() {
        return Optional.ofNullable((RenderTab) tabs.getSelectionModel().getSelectedItem());
    }
}
