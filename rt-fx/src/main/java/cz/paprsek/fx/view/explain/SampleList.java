package cz.paprsek.fx.view.explain;

import cz.paprsek.material.Rgb;
import cz.paprsek.render.explain.LinearRgb;
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

/** The rays of a pixel that has many, or paths that are typical of it: what each brings, and what they make together. One of them is chosen, whose tree is shown. */
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
    void show(Explained pixel, int chosen) {
        filling = true;
        patch.setFill(color(pixel.light()));
        sum.setText(pixel.sum(words));
        list.setCellFactory(view -> new SampleCell(pixel));
        list.getItems().setAll(IntStream.range(0, pixel.size()).boxed().toList());
        list.getSelectionModel().select(chosen);
        list.scrollTo(Math.max(0, chosen - 1));
        filling = false;
    }

    static Color color(LinearRgb light) {
        Rgb shown = light.shown();
        return Color.rgb((int) Math.rint(shown.red()), (int) Math.rint(shown.green()), (int) Math.rint(shown.blue()));
    }

    private final class SampleCell extends ListCell<Integer> {
        private final Explained pixel;
        private final Rectangle patch = new Rectangle(14, 14);

        SampleCell(Explained pixel) {
            this.pixel = pixel;
            // As wide as the list, in as many lines as it needs.
            setPrefWidth(0);
            setWrapText(true);
        }

        @Override
        protected void updateItem(Integer sample, boolean empty) {
            super.updateItem(sample, empty);
            boolean isShown = !empty && sample != null && sample < pixel.size();
            setGraphic(isShown ? patch : null);
            setText(isShown ? pixel.line(sample, words) : "");
            if (isShown) {
                patch.setFill(color(pixel.ray(sample).light()));
            }
        }
    }
}
