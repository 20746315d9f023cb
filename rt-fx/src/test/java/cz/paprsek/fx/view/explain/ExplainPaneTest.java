package cz.paprsek.fx.view.explain;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.drawing.RayLine;
import cz.paprsek.fx.Gui;
import cz.paprsek.fx.Screenshots;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.text.Outline;
import cz.paprsek.render.explain.text.Step;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Orientation;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.Labeled;
import javafx.scene.control.ListView;
import javafx.scene.control.ScrollBar;
import javafx.scene.control.Slider;
import javafx.scene.control.TableView;
import javafx.scene.control.TreeView;
import javafx.scene.image.PixelReader;
import javafx.scene.input.KeyCode;
import javafx.scene.paint.Color;
import javafx.scene.text.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class ExplainPaneTest {
    private final ExplainPane pane = Gui.on(() -> pane(new SimpleObjectProperty<>(Theme.LIGHT)));
    private final Gui gui = Gui.show(() -> pane, 1000, 900);
    private final PicturePoint point = glassBall();

    private static ExplainPane pane(ObservableValue<Theme> theme) {
        ExplainPane pane = new ExplainPane(Texts.in(Locale.ENGLISH), theme, (owner, name) -> Optional.empty());
        pane.addDrawings(theme);
        return pane;
    }

    private static PicturePoint glassBall() {
        try {
            var scene = SceneFiles.read(Path.of("../scenes/showcase.xml"));
            return new PicturePoint(RenderScene.of(scene), scene.settings().withSize(640, 360).withSamples(1), 355.5, 215.5);
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    @AfterEach
    void close() {
        gui.close();
    }

    @SuppressWarnings("unchecked")
    private TreeView<Outline> tree() {
        return (TreeView<Outline>) gui.node("#explain-tree");
    }

    @SuppressWarnings("unchecked")
    private TableView<Step> steps() {
        return (TableView<Step>) gui.node("#explain-steps");
    }

    @Test
    void aPixelShowsItsTreeAndTheExerciseOfTheRayThatIsSelected() {
        gui.act(() -> pane.show(point));
        assertThat(tree().getRoot().getValue().name()).isEqualTo("E");
        assertThat(steps().getItems()).extracting(Step::name).contains("refraction", "light of E");
        TreeView<Outline> tree = tree();
        gui.act(() -> tree.getSelectionModel().select(2));
        assertThat(steps().getItems()).extracting(Step::name).contains("light of ET");
        assertThat(Screenshots.save(gui, "explain")).isNotEmptyFile();
    }

    @Test
    void aPixelOfPathsListsTheWaysThatItsLightCame() {
        PicturePoint paths = new PicturePoint(point.scene(), point.settings().withIntegrator(Integrator.PATH).withSamples(64), point.x(), point.y());
        gui.act(() -> pane.show(paths));
        gui.until("it is explained", () -> pane.told().isPresent());
        ListView<?> ways = (ListView<?>) gui.node("#explain-samples");
        assertThat(ways.getItems()).hasSizeGreaterThan(1);
        assertThat(Gui.on(((Labeled) gui.node("#explain-sum"))::getText)).startsWith("the average of 64 paths = ");
        gui.act(() -> ways.getSelectionModel().select(1));
        assertThat(tree().getRoot().getValue().ray()).isEqualTo(pane.told().orElseThrow().ray(1));
        assertThat(pane.drawnProperty().get()).as("its rays are drawn").isPresent();
        assertThat(pane.told().orElseThrow().line(0, Texts.in(Locale.ENGLISH).words())).contains(" > eye");
        assertThat(Screenshots.save(gui, "explain-paths")).isNotEmptyFile();
    }

    @Test
    void aPixelOfManyRaysListsThemAndShowsTheTreeOfTheChosenOne() {
        PicturePoint many = new PicturePoint(point.scene(), point.settings().withSamples(4), point.x(), point.y());
        Pixel pixel = many.scene().explain(many.settings(), many.column(), many.row());
        gui.act(() -> pane.show(many));
        gui.until("all rays are listed", () -> pane.pixel().isPresent());
        assertThat(pane.pixel()).as("what is rendered, bit for bit").contains(pixel);
        ListView<?> samples = (ListView<?>) gui.node("#explain-samples");
        assertThat(samples.getItems()).hasSize(16);
        assertThat(Gui.on(((Labeled) gui.node("#explain-sum"))::getText)).startsWith("the average of 16 rays = ");
        gui.act(() -> samples.getSelectionModel().select(15));
        assertThat(tree().getRoot().getValue().ray()).isEqualTo(pixel.rays().get(15));
        assertThat(Screenshots.save(gui, "explain-samples")).isNotEmptyFile();
        gui.act(() -> pane.show(point));
        assertThat(gui.stage().getScene().lookup("#explain-samples")).as("one ray needs no list").isNull();
    }

    /** Lines are broken where a pane is narrow; nothing has to be scrolled sideways. */
    @Test
    void allOfALineIsSeenInANarrowPane() {
        PicturePoint paths = new PicturePoint(point.scene(), point.settings().withIntegrator(Integrator.PATH).withSamples(4), point.x(), point.y());
        gui.act(() -> gui.stage().setWidth(300));
        gui.act(() -> pane.show(paths));
        gui.until("it is explained", () -> pane.told().isPresent());
        gui.pulse();
        assertThat(Screenshots.save(gui, "explain-narrow")).isNotEmptyFile();
        // At some of these widths a row would have room but for its indent.
        for (int width = 300; width <= 460; width += 10) {
            double wide = width;
            gui.act(() -> gui.stage().setWidth(wide));
            gui.pulse();
            for (String list : List.of("#explain-samples", "#explain-tree")) {
                Node shown = gui.node(list);
                assertThat(Gui.on(() -> shown.lookupAll(".scroll-bar").stream().map(ScrollBar.class::cast).filter(bar -> bar.getOrientation() == Orientation.HORIZONTAL && bar.isVisible()).toList())).as(list).isEmpty();
                assertThat(Gui.on(() -> shown.lookupAll(".cell").stream().map(Labeled.class::cast).filter(cell -> isSeen(cell, shown) && isCut(cell)).map(Labeled::getText).toList())).as(list + " " + width).isEmpty();
            }
        }
    }

    private static boolean isSeen(Labeled cell, Node list) {
        return !cell.getText().isEmpty() && list.localToScene(list.getLayoutBounds()).contains(cell.localToScene(cell.getLayoutBounds()));
    }

    private static boolean isCut(Labeled cell) {
        return cell.lookupAll(".text").stream().map(Text.class::cast).noneMatch(text -> text.getText().replaceAll("\\s", "").equals(cell.getText().replaceAll("\\s", "")));
    }

    @Test
    void arrowKeysGoFromPixelToPixel() {
        gui.act(() -> pane.show(point));
        gui.act(pane::takeKeys);
        gui.keys(KeyCode.RIGHT);
        gui.keys(KeyCode.DOWN);
        gui.until("the pixel right below is explained", () -> pane.explained().filter(now -> now.column() == 356 && now.row() == 216).isPresent());
    }

    @Test
    void noRayStrikesTheNamesOfTheDrawingsThrough() {
        List<List<Color>> without = names();
        gui.act(() -> pane.show(point));
        gui.until("rays are drawn", () -> pane.drawnProperty().get().isPresent());
        gui.pulse();
        assertThat(names()).isEqualTo(without);
    }

    /** The pixels of the corners where the drawings have their names. */
    private List<List<Color>> names() {
        Parent drawings = (Parent) gui.node("#explain-drawings");
        return Gui.on(() -> drawings.getChildrenUnmodifiable().stream().map(drawing -> {
            PixelReader pixels = drawing.snapshot(null, null).getPixelReader();
            return IntStream.range(0, 48 * 12).mapToObj(i -> pixels.getColor(6 + i % 48, 5 + i / 48)).toList();
        }).toList());
    }

    @Test
    void theTreeGrowsRayByRay() {
        gui.act(() -> pane.show(point));
        Slider grown = (Slider) gui.node("#explain-grown");
        assertThat(grown.getMax()).isEqualTo(grown.getValue()).isGreaterThan(3);
        assertThat(Gui.on(() -> grown.getParent().isVisible())).isTrue();
        gui.act(pane::clear);
        assertThat(Gui.on(() -> grown.getParent().isVisible())).as("no ray, nothing to slide").isFalse();
        gui.act(() -> pane.show(point));
        gui.act(() -> grown.setValue(3));
        TreeView<Outline> tree = tree();
        assertThat(Gui.on(() -> tree.getSelectionModel().getSelectedIndex())).as("the newest ray is chosen").isEqualTo(2);
        assertThat(steps().getItems()).extracting(Step::name).contains("light of ET");
        assertThat(Gui.on(() -> pane.drawnProperty().get().orElseThrow().visible())).extracting(RayLine::ray).containsOnly("E", "ER", "ET");
        gui.act(() -> grown.setValue(1));
        assertThat(Screenshots.save(gui, "explain-one-ray")).isNotEmptyFile();
    }
}
