package cz.paprsek.fx.view.manual;

import cz.paprsek.fx.view.manual.Span.Style;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javafx.scene.Node;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.scene.text.Text;
import javafx.scene.text.TextFlow;

/** A page as it is read: its blocks below each other, no wider than can be read easily. */
final class PageView extends VBox {
    private static final double WIDEST = 860;
    private static final double INDENT = 18;
    /** Of a table's width, in percent. */
    private static final double NARROWEST = 12;
    /** A word is not to be broken on a page as narrow as this, pixels, unless it would take more than this of a table, in percent. */
    private static final double NARROW_PAGE = 640;
    private static final double WIDEST_OF_WORD = 24;
    /** What a letter takes of it, and what is left free beside a word, pixels. */
    private static final double LETTER = 8.2;
    private static final double BESIDE_WORD = 14;

    /** A block, of which there may be equal ones, and what it is read in. */
    private record Shown(Block block, Node node) {}

    private final ManualPage page;
    private final Predicate<String> isKnown;
    private final Consumer<String> onLink;
    private final List<Shown> shown;

    /**
     * @param isKnown whether a link leads to a page there is
     * @param onLink goes where such a link leads
     */
    PageView(ManualPage page, Predicate<String> isKnown, Consumer<String> onLink) {
        this.page = page;
        this.isKnown = isKnown;
        this.onLink = onLink;
        getStyleClass().add("manual-page");
        setMinWidth(0);
        setMaxWidth(WIDEST);
        shown = page.blocks().stream().map(block -> new Shown(block, node(block))).toList();
        shown.forEach(one -> getChildren().add(one.node()));
    }

    /** Where a link within the page leads. */
    Optional<Node> anchored(String anchor) {
        return shown.stream().filter(one -> one.block() instanceof Block.Heading heading && heading.anchor().equals(anchor)).map(Shown::node).findFirst();
    }

    /** The blocks in which one of some words stands, in small letters, from top to bottom. */
    List<Node> having(List<String> words) {
        return shown.stream().filter(one -> words.stream().anyMatch(one.block().plain().toLowerCase(java.util.Locale.ROOT)::contains)).map(Shown::node).toList();
    }

    private Node node(Block block) {
        if (block instanceof Block.Heading heading) {
            TextFlow flow = flow(heading.text());
            flow.getStyleClass().add("manual-heading-" + Math.min(3, heading.level()));
            return flow;
        } else if (block instanceof Block.Paragraph paragraph) {
            return paragraph(paragraph);
        } else if (block instanceof Block.Code code) {
            Label label = new Label(code.text());
            label.getStyleClass().add("manual-code");
            label.setWrapText(true);
            label.setMinHeight(Region.USE_PREF_SIZE);
            label.setMaxWidth(Double.MAX_VALUE);
            return label;
        } else if (block instanceof Block.Table table) {
            return table(table);
        }
        return picture((Block.Picture) block);
    }

    private Node paragraph(Block.Paragraph paragraph) {
        TextFlow flow = flow(paragraph.text());
        if (paragraph.sign().isEmpty()) {
            return flow;
        }
        Label sign = new Label(paragraph.sign().strip());
        sign.setMinWidth(INDENT);
        sign.setStyle("-fx-padding: 0 0 0 " + INDENT * (paragraph.sign().length() - paragraph.sign().strip().length()) / 2);
        HBox.setHgrow(flow, Priority.ALWAYS);
        return new HBox(6, sign, flow);
    }

    private Node picture(Block.Picture picture) {
        Optional<java.net.URL> url = page.picture(picture.file());
        if (url.isEmpty()) {
            return flow(Span.of(picture.says()));
        }
        Image image = new Image(url.get().toExternalForm(), true);
        ImageView view = new ImageView(image);
        view.setPreserveRatio(true);
        view.setSmooth(true);
        view.setAccessibleText(picture.says());
        view.fitWidthProperty().bind(javafx.beans.binding.Bindings.createDoubleBinding(
                () -> Math.max(1, Math.min(getWidth() - 2 * INDENT, image.getWidth() <= 0 ? 1 : image.getWidth())), widthProperty(), image.widthProperty()));
        return view;
    }

    private GridPane table(Block.Table table) {
        GridPane grid = new GridPane();
        grid.getStyleClass().add("manual-table");
        int columns = table.rows().stream().mapToInt(List::size).max().orElse(1);
        double[] lengths = new double[columns];
        double[] words = new double[columns];
        for (List<List<Span>> row : table.rows()) {
            for (int i = 0; i < row.size(); i++) {
                // A column of long texts is wider, but not by as much as they are longer.
                lengths[i] = Math.max(lengths[i], Math.sqrt(Math.min(400, 4 + Span.plain(row.get(i)).length())));
                words[i] = Math.max(words[i], longestWord(Span.plain(row.get(i))));
            }
        }
        double all = java.util.Arrays.stream(lengths).sum();
        for (int i = 0; i < columns; i++) {
            ColumnConstraints constraints = new ColumnConstraints();
            double ofWord = Math.min(WIDEST_OF_WORD, 100 * (LETTER * words[i] + BESIDE_WORD) / NARROW_PAGE);
            constraints.setPercentWidth(Math.max(Math.max(NARROWEST, ofWord), 100 * lengths[i] / all));
            grid.getColumnConstraints().add(constraints);
        }
        boolean hasHeader = table.rows().get(0).stream().anyMatch(cell -> !cell.isEmpty());
        for (int i = hasHeader ? 0 : 1; i < table.rows().size(); i++) {
            for (int k = 0; k < table.rows().get(i).size(); k++) {
                TextFlow cell = flow(table.rows().get(i).get(k));
                cell.getStyleClass().add(i == 0 ? "manual-header" : "manual-cell");
                grid.add(cell, k, i);
            }
        }
        return grid;
    }

    private static int longestWord(String text) {
        return java.util.Arrays.stream(text.split("\\s+")).mapToInt(String::length).max().orElse(0);
    }

    private TextFlow flow(List<Span> spans) {
        TextFlow flow = new TextFlow();
        flow.setMinWidth(0);
        spans.forEach(span -> flow.getChildren().add(words(span)));
        return flow;
    }

    private Node words(Span span) {
        if (span.style() == Style.PICTURE) {
            return page.picture(span.link()).<Node>map(url -> new ImageView(new Image(url.toExternalForm(), true))).orElseGet(() -> new Text(span.text()));
        }
        String style = "manual-" + span.style().name().toLowerCase(java.util.Locale.ROOT);
        if (!span.link().isEmpty() && isKnown.test(span.link())) {
            Hyperlink link = new Hyperlink(span.text());
            link.getStyleClass().addAll("manual-link", style);
            link.setOnAction(event -> onLink.accept(span.link()));
            return link;
        }
        Text text = new Text(span.text());
        text.getStyleClass().addAll("manual-text", style);
        if (!span.link().isEmpty()) {
            text.getStyleClass().add("manual-address");
            Tooltip.install(text, new Tooltip(span.link()));
        }
        if (span.style() == Style.PLAIN) {
            text.setAccessibleText(span.text());
        }
        return text;
    }
}
