package cz.paprsek.fx.view.render.fields;

import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.render.Tile;
import cz.paprsek.scene.RenderSettings;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.geometry.Pos;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;

/** Which part of a picture is rendered: all of it, or a rectangle of its pixels, as {@code render --region} has it. */
public final class RegionFields extends HBox {
    private static final Pattern WORD = Pattern.compile("(\\d{1,5}),(\\d{1,5}),(\\d{1,5}),(\\d{1,5})/(\\d{1,5}x\\d{1,5})");

    private final CheckBox part;
    private final WholeNumberField x;
    private final WholeNumberField y;
    private final WholeNumberField width;
    private final WholeNumberField height;

    public RegionFields(Texts texts) {
        super(6);
        setId("render-part");
        part = new CheckBox(texts.of("render.region.part"));
        part.setId("render-region");
        Hint.of(part).set(texts.of("render.region.hint"));
        x = field("render-region-x", texts.of("render.region.x"), 0);
        y = field("render-region-y", texts.of("render.region.y"), 0);
        width = field("render-region-width", texts.of("render.width"), 1);
        height = field("render-region-height", texts.of("render.height"), 1);
        setAlignment(Pos.CENTER_LEFT);
        getChildren().addAll(part, x, new Label(","), y, new Label("·"), width, new Label("×"), height);
    }

    private WholeNumberField field(String id, String hint, int least) {
        WholeNumberField field = new WholeNumberField(id, hint, least, RenderSettings.LARGEST_SIDE, 4);
        field.disableProperty().bind(part.selectedProperty().not());
        return field;
    }

    /** Its four numbers, which count as long as a part is wished. */
    public List<WholeNumberField> fields() {
        return List.of(x, y, width, height);
    }

    /** Whether a part is wished, and not the whole picture. */
    public ReadOnlyBooleanProperty partProperty() {
        return part.selectedProperty();
    }

    /** Shows that all of a picture is wished. */
    public void setWhole() {
        part.setSelected(false);
    }

    /** Shows the middle of a picture, for whoever wishes a part. */
    public void propose(int pictureWidth, int pictureHeight) {
        fill(pictureWidth / 4, pictureHeight / 4, Math.max(1, pictureWidth / 2), Math.max(1, pictureHeight / 2));
    }

    private void fill(int left, int top, int columns, int rows) {
        x.set(left);
        y.set(top);
        width.set(columns);
        height.set(rows);
    }

    /** The part that is wished; empty for the whole picture, and as long as its numbers are none. */
    public Optional<Tile> region() {
        return part.isSelected() && areValid() ? Optional.of(new Tile(x.get(), y.get(), width.get(), height.get())) : Optional.empty();
    }

    /** Whether what is wished lies within a picture. */
    public boolean isWithin(int pictureWidth, int pictureHeight) {
        return !part.isSelected() || (areValid() && x.get() + width.get() <= pictureWidth && y.get() + height.get() <= pictureHeight);
    }

    /** Whether there is a number in each field that counts. */
    public boolean areValid() {
        return !part.isSelected() || Stream.of(x, y, width, height).allMatch(field -> field.validProperty().get());
    }

    /** What is wished of a picture as large, in a word to be remembered; empty for the whole. */
    public String word(String size) {
        return region().map(tile -> word(tile, size)).orElse("");
    }

    /** A part of a picture as large, in a word to be remembered. */
    public static String word(Tile region, String size) {
        return region.x() + "," + region.y() + "," + region.width() + "," + region.height() + "/" + size;
    }

    /** The part that such a word says, if it is of a picture as large, and lies within it. */
    public static Optional<Tile> parse(String word, String size) {
        Matcher m = WORD.matcher(word);
        if (!m.matches() || !m.group(5).equals(size)) {
            return Optional.empty();
        }
        try {
            return Optional.of(new Tile(Integer.parseInt(m.group(1)), Integer.parseInt(m.group(2)), Integer.parseInt(m.group(3)), Integer.parseInt(m.group(4))));
        } catch (IllegalArgumentException none) {
            return Optional.empty();
        }
    }

    /** Shows what such a word says; the whole picture if it says nothing of a picture as large. */
    public void say(String word, String size) {
        Optional<Tile> said = parse(word, size);
        part.setSelected(said.isPresent());
        said.ifPresent(tile -> fill(tile.x(), tile.y(), tile.width(), tile.height()));
    }
}
