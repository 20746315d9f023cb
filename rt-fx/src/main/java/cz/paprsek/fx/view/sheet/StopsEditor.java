package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.property.Property;
import cz.paprsek.fx.model.property.TypedFormula;
import cz.paprsek.fx.view.dialog.ColorBox;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Pattern.Stop;
import cz.paprsek.material.Rgb;
import cz.paprsek.scene.Scene;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.UnaryOperator;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;
import org.kordamp.ikonli.javafx.FontIcon;

/**
 * The colours of a pattern at places from 0 to 1, a line each: where, which, and a button that takes it away; below them one that adds another in the
 * middle of the widest gap. They stay in order whatever is typed. Up and down move a place by a hundredth, up to its neighbours.
 */
final class StopsEditor implements PropertyEditor {
    private static final double STEP = 0.01;
    private static final int FEWEST = 2;

    private final Property property;
    private final PropertyEdit edit;
    private final Texts texts;
    private final VBox lines = new VBox(3);
    private final VBox box;
    private final String id;
    private List<Stop> stops = List.of();
    private boolean showing;

    StopsEditor(Property property, PropertyEdit edit, Texts texts) {
        this.property = property;
        this.edit = edit;
        this.texts = texts;
        id = String.join("-", property.path());
        Button add = button("add", "mdi2p-plus", texts.of("sheet.stop.add"), this::add);
        add.setId(id + "-add");
        box = new VBox(3, lines, add);
        box.setId(id);
    }

    @Override
    public Node node() {
        return box;
    }

    @Override
    public void show(Scene scene) {
        List<Stop> now = property.read(scene).map(StopsEditor::stops).orElse(List.of());
        if (now.size() != lines.getChildren().size()) {
            lines.getChildren().setAll(now.stream().map(stop -> (Node) new Line()).toList());
        }
        if (!now.equals(stops)) {
            stops = now;
            showing = true;
            lines.getChildren().forEach(line -> ((Line) line).show());
            showing = false;
        }
    }

    private static List<Stop> stops(Object list) {
        return ((List<?>) list).stream().map(Stop.class::cast).toList();
    }

    private void change(UnaryOperator<List<Stop>> change) {
        edit.change(scene -> changed(scene, change));
    }

    private Scene changed(Scene scene, UnaryOperator<List<Stop>> change) {
        return property.change(scene, old -> {
            List<Stop> changed = new ArrayList<>(change.apply(new ArrayList<>(stops(old))));
            changed.sort(Comparator.comparingDouble(Stop::at));
            return List.copyOf(changed);
        });
    }

    /** With one of them at another place. */
    private Scene placed(Scene scene, int index, double at) {
        return changed(scene, old -> {
            old.set(index, new Stop(at, old.get(index).color()));
            return old;
        });
    }

    private void add() {
        change(old -> {
            int widest = 1;
            for (int i = 2; i < old.size(); i++) {
                widest = old.get(i).at() - old.get(i - 1).at() > old.get(widest).at() - old.get(widest - 1).at() ? i : widest;
            }
            Stop before = old.get(widest - 1);
            Stop after = old.get(widest);
            old.add(widest, new Stop((before.at() + after.at()) / 2, mixed(before.color(), after.color())));
            return old;
        });
    }

    /** Half of each, in linear light: what the pattern has there already. */
    private static Rgb mixed(Rgb a, Rgb b) {
        return Rgb.ofLinear((a.linearRed() + b.linearRed()) / 2, (a.linearGreen() + b.linearGreen()) / 2, (a.linearBlue() + b.linearBlue()) / 2);
    }

    private static Button button(String style, String icon, String meaning, Runnable action) {
        Button button = new Button("", new FontIcon(icon));
        button.getStyleClass().addAll("small-button", "stop-" + style);
        button.setAccessibleText(meaning);
        Hint.of(button).set(meaning);
        button.setOnAction(event -> action.run());
        return button;
    }

    /** One of them. */
    private final class Line extends HBox {
        private final TextField at = new TextField();
        private final ColorBox color = new ColorBox(texts);
        private final Button remove;

        Line() {
            remove = button("remove", "mdi2m-minus", texts.of("sheet.stop.remove"), () -> change(old -> {
                old.remove(index());
                return old;
            }));
            at.setPrefColumnCount(4);
            at.setMinWidth(0);
            at.setAccessibleText(texts.of("sheet.stop.at"));
            Hint.of(at).set(texts.of("sheet.stop.at"));
            at.setOnAction(event -> enter());
            at.focusedProperty().addListener((property, was, is) -> {
                if (!is) {
                    enter();
                }
            });
            at.addEventFilter(KeyEvent.KEY_PRESSED, this::pressed);
            color.setAccessibleText(texts.of("sheet.pick"));
            color.setMaxWidth(Double.MAX_VALUE);
            HBox.setHgrow(color, Priority.ALWAYS);
            color.setOnAction(event -> {
                if (!showing) {
                    Color picked = color.getValue();
                    set(new Stop(stop().at(), new Rgb(Math.rint(picked.getRed() * 255), Math.rint(picked.getGreen() * 255), Math.rint(picked.getBlue() * 255))));
                }
            });
            setSpacing(4);
            setAlignment(Pos.CENTER_LEFT);
            getChildren().addAll(at, color, remove);
        }

        private int index() {
            return lines.getChildren().indexOf(this);
        }

        private Stop stop() {
            return stops.get(index());
        }

        private void show() {
            at.setId(id + "-" + index() + "-at");
            color.setId(id + "-" + index() + "-color");
            remove.setId(id + "-" + index() + "-remove");
            at.setText(texts.number(Steps.text(stop().at())));
            Rgb rgb = stop().color();
            color.setValue(Color.color(rgb.red() / 255, rgb.green() / 255, rgb.blue() / 255));
            remove.setDisable(stops.size() <= FEWEST);
        }

        private void set(Stop fresh) {
            int index = index();
            change(old -> {
                old.set(index, fresh);
                return old;
            });
        }

        private void enter() {
            if (index() < 0 || at.getText().equals(texts.number(Steps.text(stop().at())))) {
                return;
            }
            try {
                TypedFormula typed = TypedFormula.of(at.getText());
                int index = index();
                edit.change(scene -> typed.isKept() ? typed.kept(scene, number -> placed(scene, index, number)) : placed(scene, index, typed.value()));
            } catch (IllegalArgumentException refused) {
                edit.refuse(refused);
            }
        }

        private void pressed(KeyEvent event) {
            int by = event.getCode() == KeyCode.UP ? 1 : event.getCode() == KeyCode.DOWN ? -1 : 0;
            if (by != 0) {
                int index = index();
                double least = index > 0 ? stops.get(index - 1).at() : 0;
                double most = index + 1 < stops.size() ? stops.get(index + 1).at() : 1;
                set(new Stop(Math.max(least, Math.min(most, Math.rint((stop().at() + by * STEP) * 1e6) / 1e6)), stop().color()));
                event.consume();
            } else if (event.getCode() == KeyCode.ESCAPE) {
                at.setText(texts.number(Steps.text(stop().at())));
                edit.forgive();
                event.consume();
            }
        }
    }
}
