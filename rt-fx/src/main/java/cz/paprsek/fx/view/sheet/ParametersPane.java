package cz.paprsek.fx.view.sheet;

import cz.paprsek.formula.Formula;
import cz.paprsek.formula.FormulaException;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.model.property.TypedFormula;
import cz.paprsek.fx.view.texts.Decimals;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe.Parameter;
import cz.paprsek.text.Numbers;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.control.TitledPane;
import javafx.scene.layout.VBox;

/** The parameters that a scene is made of: each a field, and a slider if it is a number that has bounds. What depends on them follows at once. */
final class ParametersPane extends TitledPane {
    private final EditorModel model;
    private final Texts texts;
    private final Clock clock;
    private final VBox rows = new VBox();
    private List<String> names = List.of();
    private final List<Row> shown = new ArrayList<>();

    /** @param clock says for which time keys are set */
    ParametersPane(EditorModel model, Texts texts, Clock clock) {
        this.model = model;
        this.clock = clock;
        this.texts = texts;
        setId("parameters");
        setText(texts.of("section.parameters"));
        setAnimated(false);
        getStyleClass().add("sheet-section");
        rows.getStyleClass().add("sheet-rows");
        setContent(rows);
    }

    void show(Scene scene) {
        List<Parameter> parameters = scene.recipe().parameters();
        setVisible(!parameters.isEmpty());
        setManaged(!parameters.isEmpty());
        List<String> now = parameters.stream().map(one -> one.name() + one.least() + one.most() + one.step()).toList();
        if (!now.equals(names)) {
            names = now;
            shown.clear();
            parameters.forEach(one -> shown.add(new Row(one)));
            rows.getChildren().setAll(shown.stream().map(row -> row.row).toList());
        }
        for (int i = 0; i < shown.size(); i++) {
            shown.get(i).show(parameters.get(i));
        }
        showKeys(scene);
    }

    /** Shows which parameters have keys at the time that is looked at. */
    void showKeys(Scene scene) {
        shown.forEach(row -> row.key.show(scene));
    }

    /** One parameter. */
    private final class Row {
        private final String name;
        private final SheetRow row;
        private final PropertyEdit edit;
        private final KeyButton key;
        private final TextField field = new TextField();
        private final Slider slider = new Slider();
        private boolean isShowing;
        private String latest = "";

        Row(Parameter parameter) {
            name = parameter.name();
            row = new SheetRow(name);
            edit = new PropertyEdit(model, name, refusal -> row.show(refusal.map(texts::sentence)));
            field.setId("parameter-" + name);
            field.setOnAction(event -> enter());
            field.focusedProperty().addListener((focus, was, is) -> {
                if (!is) {
                    enter();
                }
            });
            boolean slides = parameter.number().isPresent() && parameter.least().isPresent() && parameter.most().isPresent();
            slider.setId("parameter-slider-" + name);
            slider.setAccessibleText(name);
            if (slides) {
                slider.setMin(parameter.least().getAsDouble());
                slider.setMax(parameter.most().getAsDouble());
                slider.setBlockIncrement(parameter.step().orElse((slider.getMax() - slider.getMin()) / 100));
                slider.valueProperty().addListener((property, was, is) -> slid(parameter, is.doubleValue()));
                slider.valueChangingProperty().addListener((property, was, is) -> {
                    if (is) {
                        edit.begin();
                    } else {
                        edit.commit();
                        // What was refused on the way is not what there is.
                        model.scene().recipe().parameters().stream().filter(one -> one.name().equals(name)).forEach(this::show);
                    }
                });
                row.below(field, slider);
            } else {
                row.below(field);
            }
            PropertyEdit keys = new PropertyEdit(model, texts.of("timeline.keys-of", name), refusal -> row.show(refusal.map(texts::sentence)));
            key = KeyButton.ofParameter(name, clock, texts, keys, row);
        }

        void show(Parameter parameter) {
            isShowing = true;
            if (!latest.equals(parameter.formula())) {
                latest = parameter.formula();
                field.setText(shown(latest));
            }
            parameter.number().ifPresent(slider::setValue);
            isShowing = false;
        }

        private void slid(Parameter parameter, double value) {
            if (isShowing) {
                return;
            }
            double step = parameter.step().orElse(0);
            double least = parameter.least().orElse(0);
            double near = step > 0 ? Math.min(slider.getMax(), least + Math.rint((value - least) / step) * step) : value;
            // As many digits as the hand has, not those of the double.
            String text = Numbers.text(Math.rint(near * 1e6) / 1e6);
            if (text.equals(latest)) {
                return;
            }
            latest = text;
            field.setText(shown(text));
            if (edit.isOpen()) {
                edit.preview(scene -> with(scene, text));
            } else {
                edit.change(scene -> with(scene, text));
            }
        }

        private void enter() {
            if (field.getText().equals(shown(latest))) {
                edit.forgive();
                return;
            }
            String typed = written(field.getText().strip());
            if (typed.equals(latest)) {
                edit.forgive();
                return;
            }
            boolean isDone = edit.change(scene -> with(scene, formula(typed)));
            if (isDone) {
                latest = formula(typed);
                field.setText(shown(latest));
            }
        }

        /** A number has the decimal sign of the language; whatever else stands as in the file. */
        private String shown(String written) {
            return Decimals.shown(written, texts);
        }

        /** Where a text with a comma stood, one stays a text. */
        private String written(String typed) {
            return latest.indexOf(',') < 0 ? Decimals.written(typed) : typed;
        }

        /** Who types names wants what they stand for; a colour's name is a name as well, and stays. */
        private String formula(String typed) {
            if (typed.startsWith(TypedFormula.SIGN)) {
                return "{" + typed.substring(1).strip() + "}";
            }
            try {
                boolean isOfNames = typed.indexOf('{') < 0 && !Formula.of(typed).names().isEmpty() && typed.chars().anyMatch(c -> "+-*/^%?(".indexOf(c) >= 0);
                return isOfNames ? "{" + typed + "}" : typed;
            } catch (FormulaException text) {
                return typed;
            }
        }

        private Scene with(Scene scene, String value) {
            try {
                return SceneFiles.with(scene, Map.of(name, value));
            } catch (SceneFileException refused) {
                throw new IllegalArgumentException(refused.problems().get(0).message(), refused);
            }
        }
    }
}
