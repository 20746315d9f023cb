package cz.paprsek.fx.view.find;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.Screenshots;
import cz.paprsek.fx.view.texts.Texts;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.stream.IntStream;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import org.junit.jupiter.api.Test;

class HelpPaneTest {
    @Test
    void ballsShowWhatSymbolsStandFor() {
        HelpPane help = Gui.on(() -> new HelpPane(Texts.in(Locale.ENGLISH), List::of));
        try (Gui gui = Gui.show(() -> help, 760, 760)) {
            gui.act(() -> help.open(HelpPane.Page.GLOSSARY));
            gui.until("all balls are rendered", () -> images(help).size() == 8);
            assertThat(Gui.on(() -> images(help).stream().map(HelpPaneTest::pixels).toList())).doesNotHaveDuplicates();
            assertThat(Screenshots.save(gui, "glossary")).isNotEmptyFile();
        }
    }

    private static List<Image> images(HelpPane help) {
        return help.lookupAll(".image-view").stream().map(ImageView.class::cast).map(ImageView::getImage).filter(Objects::nonNull).toList();
    }

    private static List<Integer> pixels(Image image) {
        int side = (int) image.getWidth();
        return IntStream.range(0, side * side).map(i -> image.getPixelReader().getArgb(i % side, i / side)).boxed().toList();
    }
}
