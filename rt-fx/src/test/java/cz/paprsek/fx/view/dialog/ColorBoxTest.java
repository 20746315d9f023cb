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
import javafx.scene.control.Slider;
import javafx.scene.layout.StackPane;
import javafx.scene.paint.Color;
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

    @Test
    void anotherColourThanThoseOfThePaletteIsMixed() {
        try (Gui gui = Gui.show(() -> new StackPane(box), 300, 200)) {
            gui.act(box::show);
            gui.until("the palette has our words", () -> found(".hyperlink").anyMatch(link -> link instanceof Hyperlink text && text.getText().equals("Jiná barva…")));
            Platform.runLater(() -> found(".hyperlink").map(Hyperlink.class::cast).forEach(Hyperlink::fire));
            gui.until("the question is asked", () -> found("#color-hue").findAny().isPresent());
            gui.act(() -> {
                Stage dialog = (Stage) found("#color-hue").findAny().orElseThrow().getScene().getWindow();
                assertThat(dialog.getModality()).as("what would fix the window behind").isEqualTo(Modality.NONE);
                ((Slider) found("#color-hue").findAny().orElseThrow()).setValue(120);
                ((Slider) found("#color-saturation").findAny().orElseThrow()).setValue(50);
                ((Slider) found("#color-brightness").findAny().orElseThrow()).setValue(80);
                found(".button").map(Button.class::cast).filter(Button::isDefaultButton).forEach(Button::fire);
            });
            gui.until("it is chosen", () -> told.get() == 1);
            Color color = Gui.on(box::getValue);
            assertThat(color.getHue()).isCloseTo(120, within(0.5));
            assertThat(color.getSaturation()).isCloseTo(0.5, within(0.01));
        }
    }
}
