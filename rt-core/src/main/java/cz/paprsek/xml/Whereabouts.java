package cz.paprsek.xml;

import cz.paprsek.xml.recipe.Script;
import cz.paprsek.xml.recipe.Script.Wrong;
import cz.paprsek.xml.text.Encoding;
import cz.paprsek.xml.text.FileText;
import cz.paprsek.xml.text.Places;
import cz.paprsek.xml.text.Places.Place;
import cz.paprsek.xml.text.Places.Step;
import cz.paprsek.xml.text.Unpatchable;
import java.util.List;
import java.util.Optional;

/** Where in a file that stands what there is to be said something of. What is made of formulas, copies and definitions stands where they do, also in a file that is included. */
final class Whereabouts {
    private static final List<String> NAMING = List.of("file", "font");

    private final String file;
    private final Optional<Script> script;
    private final Optional<Places> places;

    /** Of a file that is valid, made in such a way. */
    Whereabouts(String file, byte[] bytes, Making how) {
        this.file = file;
        Optional<Script> made = script(file, bytes, how);
        script = made.filter(one -> one.mistakes().isEmpty());
        places = made.isPresent() && script.isEmpty() ? Optional.empty() : text(script.map(Script::text).orElse(bytes)).map(FileText::places);
    }

    private static Optional<Script> script(String file, byte[] bytes, Making how) {
        try {
            byte[] utf8 = Encoding.of(bytes).toUtf8(bytes);
            return how.mayMake(utf8) ? Script.of(utf8, file, how.parameters(), how.moment(), how.files(), SceneFiles.LARGEST) : Optional.empty();
        } catch (Unpatchable e) {
            return Optional.empty();
        }
    }

    static Optional<FileText> text(byte[] bytes) {
        try {
            return Optional.of(new FileText(bytes));
        } catch (Unpatchable e) {
            return Optional.empty();
        }
    }

    /** What is to be said of an element, or of one of its attributes, as {@link Places#of} finds it. */
    Problem of(int scene, List<Step> way, String attribute, String message) {
        return at(places.map(known -> known.of(scene, way, attribute)), List.of(attribute), message);
    }

    /** What is to be said of a file that a scene names. */
    Problem naming(int scene, String named, String message) {
        return at(places.map(known -> known.naming(scene, NAMING, named)), NAMING, message);
    }

    private Problem at(Optional<Place> found, List<String> attributes, String message) {
        Place place = found.orElse(new Place(1, 1));
        Wrong wrong = script.map(made -> made.wrong(place.line(), message, attributes)).orElse(new Wrong(file, place.line(), place.column(), message));
        return new Problem(wrong.file(), wrong.line(), wrong.column(), wrong.message());
    }
}
