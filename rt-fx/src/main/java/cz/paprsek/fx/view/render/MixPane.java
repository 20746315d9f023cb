package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.dialog.ColorBox;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.render.Mixer.Setting;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.io.Failures;
import cz.paprsek.material.Rgb;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.util.ArrayList;
import java.util.List;
import javafx.application.Platform;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Slider;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;

/** The mixing desk of a finished picture: of each light whether it shines, how bright in stops, and through which colour. Nothing is rendered again. */
final class MixPane extends VBox {
    private static final double MOST_STOPS = 4;
    private static final double STEP = 1.0 / 3;
    private static final double WIDTH = 210;

    private final Mixer mixer;
    private final Texts texts;
    private final List<Strip> strips = new ArrayList<>();

    /** @param scene whose lights they are, in the order of the layers */
    MixPane(Scene scene, Mixer mixer, Texts texts) {
        super(8);
        this.mixer = mixer;
        this.texts = texts;
        setId("render-mix-pane");
        getStyleClass().add("render-mix");
        setPrefWidth(WIDTH);
        setMinWidth(WIDTH);
        Button reset = new Button(texts.of("render.mix.reset"));
        reset.setId("render-mix-reset");
        reset.setOnAction(event -> reset());
        List<String> words = mixer.lights();
        VBox all = new VBox(10);
        for (int i = 0; i < words.size(); i++) {
            String name = i < scene.lights().size() ? PathNames.of(scene, ScenePath.light(i), texts) : texts.of("render.mix.rest");
            Strip strip = new Strip(i, words.get(i), name);
            strips.add(strip);
            all.getChildren().add(strip.box);
        }
        ScrollPane scroll = new ScrollPane(all);
        scroll.setFitToWidth(true);
        VBox.setVgrow(scroll, Priority.ALWAYS);
        Label failed = new Label();
        failed.setId("render-mix-failed");
        failed.setWrapText(true);
        failed.setMinHeight(Region.USE_PREF_SIZE);
        failed.visibleProperty().bind(failed.textProperty().isNotEmpty());
        failed.managedProperty().bind(failed.visibleProperty());
        mixer.setOnMixed(failure -> {
            String text = failure.map(what -> texts.of("render.mix.failed", texts.sentence(Failures.sentence(what)))).orElse("");
            Platform.runLater(() -> failed.setText(text));
        });
        getChildren().addAll(new Label(texts.of("render.mix.title")), scroll, failed, reset);
    }

    private void reset() {
        strips.forEach(Strip::reset);
        mixer.reset();
    }

    /** One light's controls. */
    private final class Strip {
        private final String word;
        private final CheckBox shines = new CheckBox();
        private final Slider stops = new Slider(-MOST_STOPS, MOST_STOPS, 0);
        private final Label value = new Label();
        private final ColorBox color = new ColorBox(texts);
        private final Node box;
        private boolean isShowing;

        private Strip(int number, String word, String name) {
            this.word = word;
            shines.setText(name);
            shines.setId("mix-shines-" + number);
            Hint.of(shines).set(texts.of("render.mix.shines.hint"));
            stops.setId("mix-stops-" + number);
            stops.setBlockIncrement(STEP);
            Hint.of(stops).set(texts.of("render.exposure.hint"));
            stops.setAccessibleText(name + ": " + texts.of("render.exposure.hint"));
            color.setId("mix-color-" + number);
            Hint.of(color).set(texts.of("render.mix.color.hint"));
            color.setAccessibleText(name + ": " + texts.of("render.mix.color.hint"));
            HBox.setHgrow(stops, Priority.ALWAYS);
            value.setMinWidth(44);
            value.setAlignment(Pos.CENTER_RIGHT);
            HBox row = new HBox(4, stops, value, color);
            row.setAlignment(Pos.CENTER_LEFT);
            row.disableProperty().bind(shines.selectedProperty().not());
            box = new VBox(2, shines, row);
            show(mixer.setting(word));
            shines.setOnAction(event -> changed());
            color.setOnAction(event -> changed());
            stops.valueProperty().addListener((property, old, now) -> changed());
        }

        private void show(Setting setting) {
            isShowing = true;
            shines.setSelected(setting.shines());
            stops.setValue(setting.stops());
            Rgb rgb = setting.through();
            color.setValue(Color.rgb((int) Math.round(rgb.red()), (int) Math.round(rgb.green()), (int) Math.round(rgb.blue())));
            tell();
            isShowing = false;
        }

        private void reset() {
            show(Setting.WHOLE);
        }

        private void changed() {
            if (!isShowing) {
                tell();
                mixer.set(word, setting());
            }
        }

        private void tell() {
            value.setText(String.format(texts.locale(), "%+.2f", stops.getValue()));
        }

        private Setting setting() {
            Rgb through = new Rgb(Math.rint(255 * color.getValue().getRed()), Math.rint(255 * color.getValue().getGreen()), Math.rint(255 * color.getValue().getBlue()));
            return new Setting(shines.isSelected(), stops.getValue(), through);
        }
    }
}
