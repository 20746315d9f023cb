package cz.paprsek.fx.view.sheet;

import cz.paprsek.formula.Formula;
import cz.paprsek.formula.Maker;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.property.TypedFormula;
import cz.paprsek.fx.view.texts.Decimals;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.text.Numbers;
import cz.paprsek.xml.SceneFiles;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.control.TitledPane;
import javafx.scene.layout.VBox;

/** How what is selected is repeated, and where a definition is used: what the file says of that, with its formulas. */
final class MakersPane extends VBox {
    private static final PseudoClass MADE = PseudoClass.getPseudoClass("made");
    /** A number or a formula of several that stand beside each other. */
    private static final Pattern TOKEN = Pattern.compile("\\{[^}]*}|[^\\s{]+");

    private final EditorModel model;
    private final Texts texts;
    private final List<Field> fields = new ArrayList<>();
    private List<String> shown = List.of();

    /** What can be said of a maker. */
    private enum Word {
        COUNT("count", "repeat.count"), MOVE("position", "repeat.move"), TURN("rotation", "repeat.turn"), SCALE("scale", "repeat.scale");

        private final String attribute;
        private final String label;

        Word(String attribute, String label) {
            this.attribute = attribute;
            this.label = label;
        }
    }

    MakersPane(EditorModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
        setId("makers");
    }

    void show(Set<ScenePath> selection) {
        List<Maker> makers = selection.size() == 1 && selection.iterator().next() instanceof BodyAt body ? model.copies().of(body) : List.of();
        List<String> now = makers.stream().map(maker -> maker.number() + " " + title(maker)).toList();
        if (!now.equals(shown)) {
            shown = now;
            fields.clear();
            getChildren().setAll(makers.stream().map(this::pane).toList());
        }
        fields.forEach(field -> makers.stream().filter(maker -> maker.number() == field.number).findFirst().ifPresent(field::show));
        setManaged(!makers.isEmpty());
        setVisible(!makers.isEmpty());
    }

    private String title(Maker maker) {
        return maker.isRepeat() ? texts.of("section.repeat") : texts.of("section.instance", maker.attribute("of"));
    }

    private Node pane(Maker maker) {
        VBox rows = new VBox();
        rows.getStyleClass().add("sheet-rows");
        for (Word word : Word.values()) {
            if (maker.isRepeat() || word != Word.COUNT) {
                Field field = new Field(maker, word);
                fields.add(field);
                rows.getChildren().add(field.row);
            }
        }
        if (maker.isRepeat()) {
            Label hint = new Label(texts.of("repeat.hint"));
            hint.getStyleClass().add("hint");
            hint.setWrapText(true);
            rows.getChildren().add(hint);
        }
        TitledPane pane = new TitledPane(title(maker), rows);
        PropertySheet.passOpenTitle(pane);
        pane.setAnimated(false);
        pane.getStyleClass().add("sheet-section");
        return pane;
    }

    /** One attribute. */
    private final class Field {
        private final int number;
        private final Word word;
        private final SheetRow row;
        private final PropertyEdit edit;
        private final TextField text = new TextField();
        private String latest = "";

        Field(Maker maker, Word word) {
            number = maker.number();
            this.word = word;
            String label = texts.of(maker.isRepeat() ? word.label : "field." + word.attribute);
            row = new SheetRow(label).beside(text);
            edit = new PropertyEdit(model, label, refusal -> row.show(refusal.map(texts::sentence)));
            text.setId((maker.isRepeat() ? "repeat-" : "instance-") + number + "-" + word.attribute);
            text.setOnAction(event -> enter());
            text.focusedProperty().addListener((focus, was, is) -> {
                if (!is) {
                    enter();
                }
            });
        }

        void show(Maker maker) {
            String now = maker.attribute(word.attribute);
            text.setPromptText(word == Word.SCALE ? "1" : "0 0 0");
            text.pseudoClassStateChanged(MADE, now.indexOf('{') >= 0);
            if (!now.equals(latest) || text.getText().isEmpty()) {
                latest = now;
                text.setText(shown());
            }
        }

        private void enter() {
            String typed = text.getText().strip();
            if (typed.equals(shown()) || typed.equals(latest)) {
                edit.forgive();
                return;
            }
            try {
                String value = word == Word.COUNT ? number(typed) : numbers(typed);
                edit.change(scene -> SceneFiles.withMaker(scene, number, word.attribute, value));
            } catch (IllegalArgumentException refused) {
                edit.refuse(refused);
            }
        }

        /** Numbers have the decimal sign of the language, formulas stand as in the file. */
        private String shown() {
            return TOKEN.matcher(latest).replaceAll(token -> Matcher.quoteReplacement(Decimals.shown(token.group(), texts)));
        }

        private String numbers(String typed) {
            List<String> all = new ArrayList<>();
            Matcher token = TOKEN.matcher(typed);
            while (token.find()) {
                all.add(number(token.group()));
            }
            return String.join(" ", all);
        }

        /** A sum as the number that it comes to, one with names as a formula. */
        private String number(String typed) {
            if (typed.isEmpty()) {
                return "";
            }
            TypedFormula formula = TypedFormula.of(Decimals.written(typed));
            return formula.isKept() ? "{" + formula.text() + "}" : Numbers.text(Formula.value(formula.text()));
        }
    }
}
