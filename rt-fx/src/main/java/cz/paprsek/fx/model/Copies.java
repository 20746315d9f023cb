package cz.paprsek.fx.model;

import cz.paprsek.formula.Maker;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Which bodies of a scene are copies of others. What is repeated is shown, selected and changed as its first copy, which all others follow. */
public final class Copies {
    /** Of a scene in which nothing is repeated. */
    public static final Copies NONE = new Copies(List.of());

    private final List<Maker> makers;
    private final Map<List<Integer>, List<Integer>> originals = new HashMap<>();

    Copies(List<Maker> makers) {
        this.makers = List.copyOf(makers);
        for (Maker maker : makers) {
            int size = maker.originals().size();
            for (int i = size; maker.isRepeat() && i < maker.copies().size(); i++) {
                originals.put(maker.copies().get(i), maker.originals().get(i % size));
            }
        }
    }

    /** Whether nothing is repeated, and no definition used. */
    public boolean isNone() {
        return makers.isEmpty();
    }

    /** Whether a body is a copy other than the first, or within one. */
    public boolean isCopy(BodyAt body) {
        return !originals.isEmpty() && !original(body).equals(body);
    }

    /** What a body is a copy of; itself if it is none. */
    public BodyAt original(BodyAt body) {
        List<Integer> now = body.numbers();
        for (int length = 1; length <= now.size() && !originals.isEmpty(); length++) {
            List<Integer> first = originals.get(now.subList(0, length));
            if (first != null) {
                List<Integer> longer = new ArrayList<>(first);
                longer.addAll(now.subList(length, now.size()));
                now = longer;
                // The first copy of one repeat may be a later one of another.
                length = 0;
            }
        }
        return now == body.numbers() ? body : new BodyAt(now);
    }

    /** Items with the originals of those that are copies. */
    public Set<ScenePath> originals(Set<ScenePath> items) {
        if (originals.isEmpty()) {
            return items;
        }
        Set<ScenePath> all = new LinkedHashSet<>();
        items.forEach(item -> all.add(item instanceof BodyAt body ? original(body) : item));
        return all;
    }

    /** Items with all copies of each. */
    public Set<ScenePath> all(Set<ScenePath> items) {
        Set<ScenePath> all = new LinkedHashSet<>();
        for (ScenePath item : items) {
            all.add(item);
            if (item instanceof BodyAt body) {
                makers.stream().filter(maker -> maker.isRepeat() && maker.originals().contains(body.numbers())).forEach(maker -> {
                    int size = maker.originals().size();
                    for (int i = maker.originals().indexOf(body.numbers()); i < maker.copies().size(); i += size) {
                        all.add(new BodyAt(maker.copies().get(i)));
                    }
                });
            }
        }
        return all;
    }

    /** What makes a body, or an operation around it, innermost first. */
    public List<Maker> of(BodyAt body) {
        List<Maker> found = new ArrayList<>();
        for (Maker maker : makers) {
            if (maker.whole().equals(body.numbers()) || body.way().anyMatch(around -> maker.originals().contains(around.numbers()))) {
                found.add(0, maker);
            }
        }
        return found;
    }

    /** The repeat that a body is the first copy of, or that is the body; empty if it is neither. */
    public Optional<Maker> repeat(BodyAt body) {
        return makers.stream().filter(maker -> maker.isRepeat() && (maker.whole().equals(body.numbers()) || maker.originals().contains(body.numbers()))).reduce((a, b) -> b);
    }
}
