package cz.paprsek.fx.model.property;

import cz.paprsek.attribute.ElementTable;
import cz.paprsek.formula.Written;
import cz.paprsek.scene.ScenePath;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Where in a file records stand.
 *
 * @param place what has them; none for the scene itself, and for what there is once in it
 * @param elements within that, outermost first
 */
public record Spot(Optional<ScenePath> place, List<String> elements) {
    private static final Map<String, Integer> PARTS = Map.of("x", 0, "y", 1, "z", 2, "red", 0, "green", 1, "blue", 2, "width", 0, "height", 1);
    /** Components that files call otherwise. */
    private static final Map<String, String> OTHERWISE = Map.of("point", "target", "form", "size", "most-samples", "samples");

    public Spot {
        elements = List.copyOf(elements);
    }

    static Spot of(ScenePath place) {
        return new Spot(Optional.of(place), List.of());
    }

    /** Whether a formula of the same place stands for the number that a path of components leads to. */
    boolean isOf(Written formula, List<String> path) {
        boolean isWithin = formula.elements().size() >= elements.size() && formula.elements().subList(0, elements.size()).equals(elements);
        String last = file(path.get(path.size() - 1));
        String owner = path.size() > 1 ? file(path.get(path.size() - 2)) : "";
        Integer part = PARTS.get(path.get(path.size() - 1));
        if (!isWithin) {
            return false;
        }
        boolean isElement = formula.attribute().equals("color") && !formula.elements().isEmpty() && formula.elements().get(formula.elements().size() - 1).equals(owner);
        boolean isPart = part != null && (formula.attribute().equals(owner) || isElement) && (formula.count() == 1 || formula.index() == part);
        int number = path.get(path.size() - 1).equals("mostSamples") ? 1 : 0;
        return isPart || (formula.attribute().equals(last) && formula.index() == Math.min(number, formula.count() - 1));
    }

    /** What files call a component. */
    static String file(String component) {
        String name = ElementTable.hyphenated(component);
        return OTHERWISE.getOrDefault(name, name);
    }
}
