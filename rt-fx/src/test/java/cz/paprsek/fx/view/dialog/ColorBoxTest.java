package cz.paprsek.fx.view.dialog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.view.texts.Texts;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import javafx.application.Platform;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.StackPane;
import javafx.scene.paint.Color;
import javafx.scene.paint.LinearGradient;
import javafx.scene.paint.Stop;
import javafx.scene.shape.Rectangle;
import javafx.scene.text.Text;
import javafx.stage.Modality;
import javafx.stage.Stage;
import javafx.stage.Window;
import org.junit.jupiter.api.Test;

/** Any colour at all, in a dialog that leaves the windows behind it as they are. */
class ColorBoxTest {
    private final AtomicInteger told = new AtomicInteger();
    private final ColorBox box = Gui.on(() -> {
        ColorBox fresh = new ColorBox(Texts.in(Locale.forLanguageTag("cs")));
        fresh.setOnAction(event -> told.incrementAndGet());
        return fresh;
    });

    private static Stream<Node> found(String selector) {
        return List.copyOf(Window.getWindows()).stream().flatMap(window -> window.getScene().getRoot().lookupAll(selector).stream()).toList().stream();
    }

    private static Node one(String selector) {
        return found(selector).findAny().orElseThrow();
    }

    private static double slider(String id) {
        return Gui.on(() -> ((Slider) one(id)).getValue());
    }

    private static String field(String id) {
        return Gui.on(() -> ((TextField) one(id)).getText());
    }

    private static void type(String id, String text) {
        Gui.on(() -> {
            ((TextField) one(id)).setText(text);
            return true;
        });
    }

    private static Button use() {
        return Gui.on(() -> found(".button").map(Button.class::cast).filter(Button::isDefaultButton).findAny().orElseThrow());
    }

    private void ask(Gui gui) {
        gui.act(box::show);
        gui.until("the palette has our words", () -> found(".hyperlink").anyMatch(link -> link instanceof Hyperlink text && text.getText().equals("Jiná barva…")));
        Platform.runLater(() -> found(".hyperlink").map(Hyperlink.class::cast).forEach(Hyperlink::fire));
        gui.until("the question is asked", () -> found("#color-hue").findAny().isPresent());
    }

    @Test
    void anotherColourThanThoseOfThePaletteIsMixed() {
        try (Gui gui = Gui.show(() -> new StackPane(box), 300, 200)) {
            ask(gui);
            gui.act(() -> {
                Stage dialog = (Stage) one("#color-hue").getScene().getWindow();
                assertThat(dialog.getModality()).as("what would fix the window behind").isEqualTo(Modality.NONE);
                ((Slider) one("#color-hue")).setValue(120);
                ((Slider) one("#color-saturation")).setValue(50);
                ((Slider) one("#color-brightness")).setValue(80);
                use().fire();
            });
            gui.until("it is chosen", () -> told.get() == 1);
            Color color = Gui.on(box::getValue);
            assertThat(color.getHue()).isCloseTo(120, within(0.5));
            assertThat(color.getSaturation()).isCloseTo(0.5, within(0.01));
        }
    }

    @Test
    void aColourThatThePaletteDoesNotHaveIsNotFramedAtItsCorner() {
        try (Gui gui = Gui.show(() -> new StackPane(box), 300, 200)) {
            gui.act(() -> box.setValue(Color.rgb(240, 236, 226)));
            gui.act(box::show);
            gui.until("the palette is there", () -> found(".color-square").findAny().isPresent());
            assertThat(Gui.on(() -> found(".hover-square").anyMatch(Node::isVisible))).isFalse();
            gui.act(box::hide);
            gui.act(() -> box.setValue(Color.BLACK));
            gui.act(box::show);
            assertThat(Gui.on(() -> one(".hover-square").isVisible())).isTrue();
            gui.act(box::hide);
        }
    }

    @Test
    void numbersAndStripsAreInStep() {
        try (Gui gui = Gui.show(() -> new StackPane(box), 300, 200)) {
            gui.act(() -> box.setValue(Color.BLACK));
            ask(gui);
            type("#color-hex", "336699");
            assertThat(List.of(field("#color-red-field"), field("#color-green-field"), field("#color-blue-field"))).containsExactly("51", "102", "153");
            assertThat(List.of(field("#color-hue-field"), field("#color-saturation-field"), field("#color-brightness-field"))).containsExactly("210", "67", "60");
            type("#color-green-field", "300");
            assertThat(Gui.on(() -> use().isDisabled())).isTrue();
            assertThat(Gui.on(() -> ((Label) one("#color-refusal")).getText())).isEqualTo("Zelená (0–255)");
            assertThat(field("#color-hex")).as("what it was").isEqualTo("336699");
            type("#color-green-field", "153");
            assertThat(field("#color-hex")).isEqualTo("#339999");
            assertThat(slider("#color-hue")).isCloseTo(180, within(1e-3));
            Gui.on(() -> {
                use().fire();
                return true;
            });
            gui.until("it is chosen", () -> told.get() == 1);
            assertThat(Gui.on(box::getValue)).isEqualTo(Color.web("#339999"));
        }
    }

    /** Each strip shows what it gives, of which nothing could be told in black, white and grey; a typed number changes nothing else. */
    @Test
    void fromBlackColoursAreFoundByKeys() {
        try (Gui gui = Gui.show(() -> new StackPane(box), 300, 200)) {
            gui.act(() -> box.setValue(Color.BLACK));
            ask(gui);
            assertThat(Gui.on(() -> ends("#color-saturation"))).containsExactly(Color.WHITE, Color.RED);
            assertThat(Gui.on(() -> ends("#color-green"))).containsExactly(Color.BLACK, Color.LIME);
            type("#color-hue-field", "240");
            assertThat(field("#color-hex")).isEqualTo("#000000");
            gui.act(() -> one("#color-saturation").requestFocus());
            gui.keys(KeyCode.PAGE_UP);
            gui.keys(KeyCode.RIGHT);
            gui.keys(KeyCode.SHIFT, KeyCode.RIGHT);
            assertThat(slider("#color-saturation")).isEqualTo(21);
            assertThat(field("#color-brightness-field")).isEqualTo("100");
            assertThat(Gui.on(() -> ends("#color-brightness"))).containsExactly(Color.BLACK, Color.hsb(240, 0.21, 1));
            gui.keys(KeyCode.ESCAPE);
            gui.until("it is left", () -> found("#color-hue").findAny().isEmpty());
            assertThat(told.get()).isZero();
        }
    }

    /** What is looked at and used as it is changes nothing; what is no number is told whole; Escape leaves also out of a field. */
    @Test
    void nothingChangesWithoutAChange() {
        try (Gui gui = Gui.show(() -> new StackPane(box), 300, 200)) {
            Color fine = Color.color(74.5 / 255, 106.25 / 255, 148.0 / 255);
            gui.act(() -> box.setValue(fine));
            ask(gui);
            gui.act(() -> use().fire());
            gui.until("it is left", () -> found("#color-hue").findAny().isEmpty());
            assertThat(told.get()).isZero();
            assertThat(Gui.on(box::getValue)).isEqualTo(fine);
            ask(gui);
            for (String wrong : List.of("1,5", "1e3", "300")) {
                type("#color-red-field", wrong);
                assertThat(field("#color-red-field")).isEqualTo(wrong);
                assertThat(Gui.on(() -> use().isDisabled())).as(wrong).isTrue();
            }
            type("#color-red-field", "1");
            type("#color-hex", "#12");
            gui.pulse();
            Label told = (Label) one("#color-refusal");
            assertThat(Gui.on(() -> ((Text) told.lookup(".text")).getText())).as("not cut off").isEqualToIgnoringWhitespace(told.getText()).contains("modrou");
            gui.act(() -> one("#color-hex").requestFocus());
            gui.keys(KeyCode.ESCAPE);
            gui.until("it is left", () -> found("#color-hue").findAny().isEmpty());
            assertThat(Gui.on(box::getValue)).isEqualTo(fine);
        }
    }

    private static List<Color> ends(String strip) {
        Rectangle way = (Rectangle) one(strip).getParent().getChildrenUnmodifiable().get(0);
        List<Stop> stops = ((LinearGradient) way.getFill()).getStops();
        return List.of(stops.get(0).getColor(), stops.get(stops.size() - 1).getColor());
    }

    /** JavaFX calls them by English names in capitals, or by numbers as no file has them. */
    @Test
    void coloursOfThePaletteAreCalledByTheirNames() {
        try (Gui gui = Gui.show(() -> new StackPane(box), 300, 200)) {
            gui.act(box::show);
            gui.until("there are colours", () -> found(".color-square").count() > 100);
            Node white = Gui.on(() -> found(".color-square").filter(square -> square.lookup(".color-rect") instanceof Rectangle shown && shown.getFill().equals(Color.WHITE)).findFirst().orElseThrow());
            gui.moveTo(white, 5, 5);
            gui.until("it says", () -> Window.getWindows().stream().anyMatch(window -> window instanceof Tooltip told && told.getText().equals("Bílá · #ffffff")));
            gui.act(box::hide);
        }
        assertThat(ColorNames.of(Color.DARKGRAY, Texts.in(Locale.ENGLISH))).isEqualTo("Dark grey · #a9a9a9");
        assertThat(ColorNames.of(Color.web("#123456"), Texts.in(Locale.ENGLISH))).isEqualTo("#123456");
    }
}
