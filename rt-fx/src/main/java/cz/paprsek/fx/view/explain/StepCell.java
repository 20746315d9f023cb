package cz.paprsek.fx.view.explain;

import cz.paprsek.render.explain.text.Step;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import javafx.scene.control.TableCell;
import javafx.scene.layout.Region;
import javafx.scene.text.Text;

/** A line of the exercise in as many lines as it needs, broken between numbers rather than within them, and between vectors if these have room. */
final class StepCell extends TableCell<Step, String> {
    private static final double PADDING = 16;
    private static final Pattern HEAD = Pattern.compile("^(\\S{1,2}) = ");
    private final Text text = new Text();
    private String item = "";

    StepCell() {
        text.getStyleClass().add("explain-step");
        text.wrappingWidthProperty().bind(widthProperty().subtract(PADDING));
        widthProperty().addListener(property -> write());
        setPrefHeight(Region.USE_COMPUTED_SIZE);
    }

    @Override
    protected void updateItem(String fresh, boolean empty) {
        super.updateItem(fresh, empty);
        item = empty || fresh == null ? "" : fresh;
        write();
        setGraphic(empty ? null : text);
    }

    private void write() {
        String fitting = getWidth() <= 0 ? item : broken(item, run -> {
            Text measured = new Text(run);
            measured.setFont(text.getFont());
            return measured.getLayoutBounds().getWidth() <= text.getWrappingWidth();
        });
        if (!fitting.equals(text.getText())) {
            text.setText(fitting);
        }
    }

    /**
     * A line that is broken at blanks only where it may be: before signs, but not after a letter that begins it, as in {@code d = (0, 0, -1)}; between vectors that are multiplied, if it has to be; between numbers if even a vector has no room.
     *
     * @param hasRoom whether what is not to be broken has room
     */
    static String broken(String line, Predicate<String> hasRoom) {
        String parts = HEAD.matcher(line).replaceFirst("$1\u00a0= ").replace("+ ", "+\u00a0").replace("= ", "=\u00a0");
        String vectors = parts.replace(", ", ",\u00a0").replace("; ", ";\u00a0");
        List<String> ways = List.of(vectors, vectors.replace("·(", "· ("), parts.replace("·(", "· ("));
        return ways.stream().filter(way -> Arrays.stream(way.split(" ")).allMatch(hasRoom)).findFirst().orElse(ways.get(ways.size() - 1));
    }
}
