package cz.paprsek.fx.view.explain;

import cz.paprsek.material.Rgb;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.text.TreeText;
import cz.paprsek.words.Words;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;
import javafx.scene.shape.Rectangle;

/** The rays of a pixel that has many: what each brings, and what they make together. One of them is chosen, whose tree is shown. */
final class SampleList extends VBox {
    private final Words words;
    private final Rectangle patch = new Rectangle(14, 14);
    private final Label sum = new Label("", patch);
    private final ListView<Integer> list = new ListView<>();
    private IntConsumer onChosen = sample -> {};
    private boolean filling;

    SampleList(Words words) {
        this.words = words;
        sum.setId("explain-sum");
        sum.setWrapText(true);
        sum.setMinHeight(USE_PREF_SIZE);
        list.setId("explain-samples");
        list.getSelectionModel().selectedItemProperty().addListener((property, old, now) -> {
            if (!filling && now != null) {
                onChosen.accept(now);
            }
        });
        VBox.setVgrow(list, Priority.ALWAYS);
        getChildren().addAll(sum, list);
    }

    void setOnChosen(IntConsumer listener) {
        onChosen = listener;
    }

    /** Lists the rays of a pixel, of which one is chosen. */
    void show(Pixel pixel, int chosen) {
        filling = true;
        patch.setFill(color(pixel.light()));
        sum.setText(TreeText.sum(pixel, words));
        list.setCellFactory(view -> new SampleCell(pixel));
        list.getItems().setAll(IntStream.range(0, pixel.rays().size()).boxed().toList());
        list.getSelectionModel().select(chosen);
        list.scrollTo(Math.max(0, chosen - 1));
        filling = false;
    }

    /** The ray that brings light most like the pixel's own: the best to begin with. */
    static int mostTypical(Pixel pixel) {
        LinearRgb all = pixel.light();
        int best = 0;
        for (int i = 1; i < pixel.rays().size(); i++) {
            best = distance(pixel.rays().get(i).light(), all) < distance(pixel.rays().get(best).light(), all) ? i : best;
        }
        return best;
    }

    private static double distance(LinearRgb a, LinearRgb b) {
        return Math.abs(a.red() - b.red()) + Math.abs(a.green() - b.green()) + Math.abs(a.blue() - b.blue());
    }

    static Color color(LinearRgb light) {
        Rgb shown = light.shown();
        return Color.rgb((int) Math.rint(shown.red()), (int) Math.rint(shown.green()), (int) Math.rint(shown.blue()));
    }

    private final class SampleCell extends ListCell<Integer> {
        private final Pixel pixel;
        private final Rectangle patch = new Rectangle(14, 14);

        SampleCell(Pixel pixel) {
            this.pixel = pixel;
        }

        @Override
        protected void updateItem(Integer sample, boolean empty) {
            super.updateItem(sample, empty);
            boolean isShown = !empty && sample != null && sample < pixel.rays().size();
            setGraphic(isShown ? patch : null);
            setText(isShown ? TreeText.sample(pixel, sample, words) : "");
            if (isShown) {
                patch.setFill(color(pixel.rays().get(sample).light()));
            }
        }
    }
}
