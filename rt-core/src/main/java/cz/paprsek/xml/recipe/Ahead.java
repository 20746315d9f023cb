package cz.paprsek.xml.recipe;

import cz.paprsek.text.Numbers;
import cz.paprsek.xml.format.SceneFormat;
import cz.paprsek.xml.recipe.Names.ToldAlready;
import cz.paprsek.xml.recipe.Node.Attr;
import cz.paprsek.xml.recipe.Template.Misplaced;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * How many copies elements will make, told without making them: a few lines can ask for more than there may be, and writing out as many as there may be takes
 * seconds. What is repeated as often as the number of a copy says counts as nothing here.
 */
final class Ahead {
    private final Names names;
    private final Map<String, Node> definitions;
    private final Set<String> indices = new HashSet<>();
    private final Map<String, Double> known = new HashMap<>();
    private int depth;

    private Ahead(Node scene, Names names, Map<String, Node> definitions) {
        this.names = names;
        this.definitions = definitions;
        indices.add(Expansion.INDEX);
        collect(scene.children());
        collect(definitions.values());
    }

    private void collect(Collection<Node> nodes) {
        for (Node node : nodes) {
            node.attribute("index").map(Attr::text).ifPresent(indices::add);
            collect(node.children());
        }
    }

    /** The element of a scene at which there are more copies than there may be. */
    static Optional<Node> tooMany(Node scene, Names names, Map<String, Node> definitions) {
        Ahead ahead = new Ahead(scene, names, definitions);
        double all = 0;
        for (Node child : scene.children()) {
            all += ahead.copies(child);
            if (all > Copies.MOST) {
                return Optional.of(child);
            }
        }
        return Optional.empty();
    }

    /** At least so many copies come of an element; infinitely many for more than there are numbers. What is nested too deep is refused when it is written out. */
    private double copies(Node node) {
        if (depth >= SceneFormat.DEEPEST) {
            return 0;
        }
        depth++;
        double copies = switch (node.name()) {
            case Node.REPEAT -> count(node) * node.children().stream().filter(Node::isBody).mapToDouble(one -> 1 + copies(one)).sum();
            case Node.INSTANCE -> node.attribute("of").map(of -> 1 + used(of.text())).orElse(0.0);
            default -> node.isOperation() ? node.children().stream().mapToDouble(this::copies).sum() : 0;
        };
        depth--;
        return copies;
    }

    private double used(String definition) {
        Node body = definitions.get(definition);
        Double before = known.get(definition);
        if (body == null || before != null) {
            return before == null ? 0 : before;
        }
        // One that needs itself is refused when it is written out.
        known.put(definition, 0.0);
        double copies = copies(body);
        known.put(definition, copies);
        return copies;
    }

    private int count(Node repeat) {
        try {
            double count = repeat.attribute("count").filter(this::isKnown).map(given -> given.template().isPresent() ? given.template().get().value(names) : given.text())
                    .stream().flatMapToDouble(text -> Numbers.parsed(text.strip()).stream()).findFirst().orElse(0);
            return count >= 0 && count <= Copies.MOST ? (int) count : 0;
        } catch (Misplaced | ToldAlready without) {
            return 0;
        }
    }

    private boolean isKnown(Attr count) {
        return count.template().isEmpty() || count.template().get().names().stream().noneMatch(indices::contains);
    }
}
