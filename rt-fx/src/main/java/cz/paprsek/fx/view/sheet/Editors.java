package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.model.property.Alternatives;
import cz.paprsek.fx.model.property.Property;
import cz.paprsek.fx.view.command.Command;
import cz.paprsek.fx.view.command.FileFinder;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.Text;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.stream.Stream;
import javafx.beans.property.BooleanProperty;
import javafx.scene.Node;
import javafx.scene.control.ToggleButton;
import org.kordamp.ikonli.javafx.FontIcon;

/** Makes the row and the editor for a property of any kind. */
final class Editors {
    private final EditorModel model;
    private final Texts texts;
    private final BooleanProperty proportional;
    private final FileFinder finder;
    private final Clock clock;
    private Optional<Command> pipette = Optional.empty();

    Editors(EditorModel model, Texts texts, BooleanProperty proportional, FileFinder finder, Clock clock) {
        this.clock = clock;
        this.finder = finder;
        this.model = model;
        this.texts = texts;
        this.proportional = proportional;
    }

    void offerPipette(Command value) {
        pipette = Optional.of(value);
    }

    /**
     * What is put into the sheet, and what shows a scene in it.
     *
     * @param row the row
     * @param editor the editor in it
     * @param key sets keys of it, if there can be such
     */
    record Entry(SheetRow row, PropertyEditor editor, Optional<KeyButton> key) {}

    Entry entry(Property property) {
        Entry plain = plain(property);
        return switch (property.trait().kind()) {
            case NUMBER, WHOLE, SHARE, VECTOR, FACTORS, COLOR -> new Entry(plain.row, plain.editor,
                    Optional.of(KeyButton.of(property, clock, texts, new PropertyEdit(model, texts.of("timeline.keys-of", texts.of(property.label())), refusal -> plain.row.show(refusal.map(texts::sentence))), plain.row)));
            default -> plain;
        };
    }

    private Entry plain(Property property) {
        String text = texts.of(property.label());
        SheetRow row = new SheetRow(text);
        PropertyEdit edit = new PropertyEdit(model, text, refusal -> row.show(refusal.map(texts::sentence)));
        String mixed = texts.of("sheet.mixed");
        return switch (property.trait().kind()) {
            case NUMBER, WHOLE -> {
                NumberEditor editor = new NumberEditor(property, edit, texts);
                editor.field().dragBy(row.label());
                yield beside(row, editor);
            }
            case SHARE -> {
                ShareEditor editor = new ShareEditor(property, edit, texts);
                editor.field().dragBy(row.label());
                yield beside(row, editor);
            }
            case VECTOR -> below(row, new VectorEditor(property, edit, texts, () -> false));
            case FACTORS -> {
                ToggleButton link = link();
                yield below(row, new VectorEditor(property, edit, texts, proportional::get), link);
            }
            case COLOR -> below(row, new ColorEditor(property, edit, texts, texts.of("sheet.pick")));
            case FLAG -> beside(row, new FlagEditor(id(property), text, property::read, value -> edit.change(scene -> property.write(scene, value))));
            case TEXT -> beside(row, new TextEditor(id(property), edit, scene -> property.read(scene).map(Object::toString).orElse(""),
                    property::write));
            case FONT -> beside(row, fonts(property, edit, mixed));
            case WORDS -> beside(row, new TextEditor(id(property), edit,
                    scene -> property.read(scene).map(words -> String.join(" ", words((List<?>) words))).orElse(""),
                    (scene, line) -> property.write(scene, line.isBlank() ? List.of() : List.of(line.strip().split("\\s+")))));
            case FILE -> below(row, new FileEditor(property, edit, texts, finder));
            case STOPS -> below(row, new StopsEditor(property, edit, texts));
            case CONSTANT -> beside(row, new ChoiceEditor<>(id(property), mixed,
                    constant -> texts.of("kind." + constant.toString().toLowerCase(Locale.ROOT)),
                    scene -> List.of(property.type().getEnumConstants()), property::read,
                    constant -> edit.change(scene -> property.write(scene, constant))));
            case ALTERNATIVE -> beside(row, alternatives(property, edit, mixed));
            case MATERIAL -> {
                MaterialEditor editor = new MaterialEditor(model, edit, texts, property, pipette);
                yield new Entry(row.below(editor.node(), editor.buttons()), editor, Optional.empty());
            }
        };
    }

    private PropertyEditor alternatives(Property property, PropertyEdit edit, String mixed) {
        return new ChoiceEditor<Class<?>>(id(property), mixed,
                kind -> texts.of("alternative." + kind.getSimpleName().toLowerCase(Locale.ROOT)),
                scene -> Alternatives.of(property.type()), property::kind,
                kind -> edit.change(scene -> Alternatives.choose(property, scene, kind)));
    }

    /** Those that are shipped, that of a file which the text has, and one to be chosen. */
    private PropertyEditor fonts(Property property, PropertyEdit edit, String mixed) {
        AtomicReference<PropertyEditor> itself = new AtomicReference<>();
        Function<Scene, Optional<String>> read = scene -> property.read(scene).map(Object::toString);
        ChoiceEditor<String> editor = new ChoiceEditor<>(id(property), mixed,
                font -> font.isEmpty() ? texts.of("font.file") : Text.FONTS.contains(font) ? texts.of("font." + font) : font,
                scene -> Stream.of(Text.FONTS.stream(), read.apply(scene).stream(), Stream.of("")).flatMap(all -> all).distinct().toList(), read,
                font -> font(property, edit, font, Objects.requireNonNull(itself.get())));
        itself.set(editor);
        return editor;
    }

    private void font(Property property, PropertyEdit edit, String font, PropertyEditor editor) {
        try {
            Optional<String> chosen = font.isEmpty() ? finder.find(FileFinder.Kind.FONT, editor.node().getScene().getWindow()) : Optional.of(font);
            chosen.ifPresent(name -> edit.change(scene -> property.write(scene, name)));
        } catch (IllegalArgumentException refused) {
            edit.refuse(refused);
        }
        editor.show(edit.scene());
    }

    private static List<String> words(List<?> words) {
        return words.stream().map(Object::toString).toList();
    }

    private ToggleButton link() {
        ToggleButton link = new ToggleButton("", new FontIcon("mdi2l-link-variant"));
        link.setId("scale-link");
        link.selectedProperty().bindBidirectional(proportional);
        link.setAccessibleText(texts.of("sheet.link"));
        Hint.of(link).set(texts.of("sheet.link"));
        link.getStyleClass().add("small-button");
        return link;
    }

    private static Entry beside(SheetRow row, PropertyEditor editor) {
        return new Entry(row.beside(editor.node()), editor, Optional.empty());
    }

    private static Entry below(SheetRow row, PropertyEditor editor, Node... atEnd) {
        return new Entry(row.below(editor.node(), atEnd), editor, Optional.empty());
    }

    private static String id(Property property) {
        return String.join("-", property.path());
    }
}
