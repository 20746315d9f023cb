package cz.paprsek.xml.recipe;

import cz.paprsek.io.PlainText;
import cz.paprsek.xml.mistake.Problems;
import cz.paprsek.xml.recipe.Node.Attr;
import cz.paprsek.xml.recipe.Template.Misplaced;
import cz.paprsek.xml.text.Places.Place;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** What is wrong with how scenes are made. */
final class Mistakes {
    private static final int LONGEST_MESSAGE = 500;

    private final Set<Found> found = new LinkedHashSet<>();

    /** Where in which file, both numbers from 1. */
    record Found(String file, int line, int column, String message) {}

    void add(Origin origin, int at, String message) {
        Place place = origin.place(at);
        found.add(new Found(origin.file(), place.line(), place.column(), PlainText.of(message, LONGEST_MESSAGE)));
        if (found.size() >= Problems.MOST) {
            throw new Problems.Stop();
        }
    }

    void add(Node node, String message) {
        add(node.origin(), node.at(), message);
    }

    /** Where an attribute of the element stands; the element itself if it has none of that name. */
    void add(Node node, String attribute, String message) {
        Optional<Attr> one = node.attribute(attribute);
        add(node.origin(), one.isPresent() && one.get().nameAt() >= 0 ? one.get().nameAt() : node.at(), message);
    }

    /** Within the value of an attribute. */
    void add(Node node, Attr attribute, Misplaced why) {
        boolean isInFile = attribute.valueAt() >= 0;
        add(node.origin(), isInFile ? attribute.valueAt() + node.origin().bytes(attribute.valueAt(), why.at()) : node.at(), String.valueOf(why.getMessage()));
    }

    boolean isEmpty() {
        return found.isEmpty();
    }

    List<Found> found() {
        return List.copyOf(found);
    }
}
