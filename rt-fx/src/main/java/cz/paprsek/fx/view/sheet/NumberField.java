package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.property.Property;
import cz.paprsek.fx.model.property.Trait;
import cz.paprsek.fx.model.property.TypedFormula;
import cz.paprsek.fx.view.look.OwnLayout;
import cz.paprsek.fx.view.texts.FirstClick;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Scene;
import java.util.Optional;
import java.util.function.UnaryOperator;
import javafx.css.PseudoClass;
import javafx.geometry.Pos;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;

/**
 * A number that can be typed, also as a small sum or a formula, stepped with the arrow keys, and dragged by a handle. Shows nothing if several things
 * differ; typing gives them all the same, stepping and dragging change each from where it is, and take the place of a formula.
 */
final class NumberField extends TextField implements PropertyEditor {
    private static final double PIXELS_PER_STEP = 4;
    private static final double HUNDRED = 100;
    /** Of a formula. */
    private static final PseudoClass MADE = PseudoClass.getPseudoClass("made");

    private final Property property;
    private final PropertyEdit edit;
    private final Texts texts;
    private final Writer writer;
    private Optional<Double> value = Optional.empty();
    private Optional<String> formula = Optional.empty();
    private String shown = "";
    private double arrows;
    private boolean isRounded;
    private boolean isChanging;

    /** How a number is written: the property itself, or with others in step. */
    @FunctionalInterface
    interface Writer {
        Scene write(Scene scene, UnaryOperator<Object> change);
    }

    NumberField(Property property, PropertyEdit edit, Texts texts) {
        this(property, edit, texts, property::change);
    }

    NumberField(Property property, PropertyEdit edit, Texts texts, Writer writer) {
        this.property = property;
        this.edit = edit;
        this.texts = texts;
        this.writer = writer;
        setId(String.join("-", property.path()));
        getStyleClass().add("number-field");
        setPrefColumnCount(5);
        setMinWidth(0);
        setOnAction(event -> {
            enter();
            selectAll();
        });
        focusedProperty().addListener((focus, was, is) -> {
            if (!is) {
                edit.commit();
                enter();
            }
            if (formula.isPresent() && (is || !isPending())) {
                reset();
            }
        });
        FirstClick.takesAll(this, () -> formula.isEmpty());
        addEventFilter(KeyEvent.KEY_PRESSED, this::pressed);
        addEventFilter(KeyEvent.KEY_RELEASED, event -> {
            if (event.getCode() == KeyCode.UP || event.getCode() == KeyCode.DOWN) {
                edit.commit();
            }
        });
    }

    @Override
    public Node node() {
        return this;
    }

    @Override
    public void show(Scene scene) {
        show(scene, property.read(scene).map(number -> ((Number) number).doubleValue()));
    }

    /** Shows a number that has been read already; none for several. */
    void show(Scene scene, Optional<Double> now) {
        String prompt = now.isEmpty() ? texts.of("sheet.mixed") : "";
        if (!prompt.equals(getPromptText())) {
            setPromptText(prompt);
        }
        Optional<String> made = edit.formula(property, scene);
        if (!now.equals(value) || !made.equals(formula) || shown.isEmpty()) {
            value = now;
            formula = made;
            pseudoClassStateChanged(MADE, made.isPresent());
            setTooltip(made.map(text -> new Tooltip(TypedFormula.SIGN + text)).orElse(null));
            isChanging = true;
            reset();
            isChanging = false;
        }
    }

    /** Another number needs no more room, and so has nothing around the field laid out anew. */
    @Override
    public void requestLayout() {
        if (isChanging && OwnLayout.suffices(this)) {
            setNeedsLayout(true);
        } else {
            super.requestLayout();
        }
    }

    /** Has hundredths shown only; the number stays as it is until another one is typed. */
    void round() {
        isRounded = true;
    }

    /** Lets the number be dragged to and fro by a node, such as its label. */
    void dragBy(Node handle) {
        handle.setCursor(Cursor.H_RESIZE);
        handle.getStyleClass().add("drag-handle");
        Drag drag = new Drag();
        handle.addEventHandler(MouseEvent.MOUSE_PRESSED, drag::press);
        handle.addEventHandler(MouseEvent.MOUSE_DRAGGED, drag::move);
        handle.addEventHandler(MouseEvent.MOUSE_RELEASED, event -> edit.commit());
    }

    /** The field behind a letter by which it can be dragged. */
    HBox behind(String text, String axis) {
        Label letter = new Label(text);
        letter.getStyleClass().addAll("axis", "axis-" + axis);
        dragBy(letter);
        HBox pair = new HBox(letter, this);
        pair.setAlignment(Pos.CENTER_LEFT);
        HBox.setHgrow(this, Priority.ALWAYS);
        HBox.setHgrow(pair, Priority.ALWAYS);
        return pair;
    }

    /** Begins to change the number from where it is. */
    void begin() {
        enter();
        edit.begin();
    }

    /** Shows the number changed by so many steps from where it was at the beginning. */
    void step(double steps) {
        Trait trait = property.trait();
        edit.preview(scene -> writer.write(scene, old -> {
            double start = ((Number) old).doubleValue();
            return steps == 0 ? old : boxed(Steps.moved(trait, start, steps * Steps.step(trait, start)));
        }));
    }

    /** Keeps what was changed step by step. */
    void commit() {
        edit.commit();
    }

    private void pressed(KeyEvent event) {
        if (event.getCode() == KeyCode.ESCAPE && (edit.isOpen() || isPending())) {
            edit.cancel();
            edit.forgive();
            reset();
            event.consume();
        } else if ((event.getCode() == KeyCode.UP || event.getCode() == KeyCode.DOWN) && !event.isShortcutDown()) {
            arrow(event.getCode() == KeyCode.UP ? Steps.factor(event) : -Steps.factor(event));
            event.consume();
        }
    }

    private void arrow(double steps) {
        if (!edit.isOpen()) {
            begin();
            arrows = 0;
        }
        arrows += steps;
        step(arrows);
    }

    private boolean isPending() {
        return !getText().equals(shown);
    }

    private void enter() {
        if (!isPending()) {
            return;
        }
        if (getText().isBlank()) {
            reset();
            edit.forgive();
            return;
        }
        try {
            TypedFormula typed = TypedFormula.of(getText());
            if (edit.change(scene -> typed.isKept() ? typed.kept(scene, number -> written(scene, number)) : written(scene, typed.value()))) {
                show(edit.scene());
                reset();
            }
        } catch (IllegalArgumentException refused) {
            edit.refuse(refused);
        }
    }

    private Scene written(Scene scene, double number) {
        Object entered = typed(number);
        return writer.write(scene, old -> entered);
    }

    /** The formula for who is about to change it, else what it comes to. */
    private void reset() {
        String number = value.map(known -> texts.number(Steps.text(isRounded ? Math.rint(HUNDRED * known) / HUNDRED : known))).orElse("");
        shown = formula.isEmpty() ? number : isFocused() ? TypedFormula.SIGN + formula.get() : "\u0192 " + number;
        setText(shown);
    }

    private Object typed(double number) {
        if (property.trait().kind() == Trait.Kind.WHOLE && number != Math.rint(number)) {
            throw new IllegalArgumentException("this must be a whole number, but is " + Steps.text(number));
        }
        return boxed(number);
    }

    private Object boxed(double number) {
        return property.trait().kind() == Trait.Kind.WHOLE ? (Object) (int) number : (Object) number;
    }

    /** One drag of the handle. */
    private final class Drag {
        private double x;
        private double steps;

        void press(MouseEvent event) {
            if (event.getButton() == MouseButton.PRIMARY) {
                x = event.getScreenX();
                steps = 0;
                // Having the focus, the field hears Escape during the drag.
                requestFocus();
                begin();
                // The sheet around would take the focus away again.
                event.consume();
            }
        }

        void move(MouseEvent event) {
            if (edit.isOpen()) {
                steps += (event.getScreenX() - x) / PIXELS_PER_STEP * Steps.factor(event);
                x = event.getScreenX();
                step(steps < 0 ? Math.ceil(steps * 10) / 10 : Math.floor(steps * 10) / 10);
            }
        }
    }
}
