package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.render.fields.Answer;
import cz.paprsek.fx.view.render.fields.WholeNumberField;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.RenderSettings;
import java.util.List;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignL;

/** How large a picture is, in pixels; while the chain is on, one side follows the other. */
final class SizeFields extends HBox {
    private record Preset(int width, int height, String name) {}

    private static final List<Preset> PRESETS = List.of(
            new Preset(320, 240, "QVGA"),
            new Preset(640, 480, "VGA"),
            new Preset(800, 600, "SVGA"),
            new Preset(1024, 768, "XGA"),
            new Preset(1280, 720, "HD"),
            new Preset(1920, 1080, "Full HD"),
            new Preset(2560, 1440, "QHD"),
            new Preset(3840, 2160, "4K UHD"),
            new Preset(1024, 1024, "1 : 1"));

    private final WholeNumberField width;
    private final WholeNumberField height;
    private final ToggleButton chain = new ToggleButton("", new FontIcon(MaterialDesignL.LINK_VARIANT));
    /** Width by height, as it is to stay. */
    private double aspect = 1;
    private boolean follows;

    SizeFields(Texts texts) {
        super(6);
        width = new WholeNumberField("render-width", texts.of("render.width"), 1, RenderSettings.LARGEST_SIDE, 5);
        height = new WholeNumberField("render-height", texts.of("render.height"), 1, RenderSettings.LARGEST_SIDE, 5);
        setId("render-size");
        chain.setId("render-chain");
        Hint.of(chain).set(texts.of("render.chain"));
        chain.setAccessibleText(texts.of("render.chain"));
        chain.selectedProperty().addListener((property, old, now) -> measure());
        width.textProperty().addListener((property, old, now) -> follow(width, height, 1 / aspect));
        height.textProperty().addListener((property, old, now) -> follow(height, width, aspect));
        MenuButton presets = new MenuButton(texts.of("render.presets"));
        presets.setId("render-presets");
        PRESETS.forEach(preset -> presets.getItems().add(item(preset)));
        setAlignment(Pos.CENTER_LEFT);
        getChildren().addAll(width, new Label("×"), height, chain, presets);
    }

    /** Width and height. */
    List<WholeNumberField> fields() {
        return List.of(width, height);
    }

    /** How large, and whether the sides are chained. */
    List<Answer> answers() {
        return List.of(new Answer("size", this::word, this::say),
                new Answer("chain", () -> Boolean.toString(chain.isSelected()), word -> chain.setSelected(Boolean.parseBoolean(word))));
    }

    /** Such as 640x480. */
    String word() {
        return width.word() + "x" + height.word();
    }

    private void say(String word) {
        int at = word.indexOf('x');
        if (at > 0) {
            set(() -> {
                width.say(word.substring(0, at));
                height.say(word.substring(at + 1));
            });
        }
    }

    /** Shows the size that is asked for if nobody says another one, with the chain off. */
    void ask(int columns, int rows) {
        chain.setSelected(false);
        set(columns, rows);
    }

    private void set(int columns, int rows) {
        set(() -> {
            width.set(columns);
            height.set(rows);
        });
    }

    private void set(Runnable both) {
        follows = true;
        both.run();
        follows = false;
        measure();
    }

    boolean areValid() {
        return width.validProperty().get() && height.validProperty().get();
    }

    /** Only if it is valid. */
    int columns() {
        return width.get();
    }

    /** Only if it is valid. */
    int rows() {
        return height.get();
    }

    private void measure() {
        if (areValid()) {
            aspect = (double) columns() / rows();
        }
    }

    private void follow(WholeNumberField changed, WholeNumberField other, double share) {
        if (chain.isSelected() && !follows && changed.validProperty().get()) {
            follows = true;
            other.set((int) Math.max(1, Math.min(RenderSettings.LARGEST_SIDE, Math.round(changed.get() * share))));
            follows = false;
        }
    }

    private MenuItem item(Preset preset) {
        MenuItem item = new MenuItem(preset.width() + " × " + preset.height() + "   " + preset.name());
        item.setOnAction(event -> set(preset.width(), preset.height()));
        return item;
    }
}
