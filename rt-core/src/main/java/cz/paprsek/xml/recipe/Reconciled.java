package cz.paprsek.xml.recipe;

import cz.paprsek.xml.recipe.Node.Attr;
import cz.paprsek.xml.text.Alignment;
import cz.paprsek.xml.text.Form;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * What becomes of the elements of a file when what came of them has been changed: formulas stay where their values have stayed, and copies stay repeated if
 * none was touched; what was touched is written down.
 */
final class Reconciled {
    private static final Set<String> OF_INSTANCE = Set.of("name", "position", "rotation", "scale", "material");

    private final IdentityHashMap<Form, Node> stemming = new IdentityHashMap<>();
    private final IdentityHashMap<Form, Node> owners = new IdentityHashMap<>();
    private final boolean movesInstances;
    private final Origin origin;

    /** An element, and which of the new ones it is, or the last of them. */
    private record Kept(Node node, int number) {}

    private Reconciled(Origin origin, boolean movesInstances) {
        this.origin = origin;
        this.movesInstances = movesInstances;
    }

    /**
     * The scene as it is to be written.
     *
     * @param written the scene with its formulas
     * @param out what it was written out as
     * @param before the same as it is written canonically
     * @param now what that has become
     * @param movesInstances whether what is placed anew where a definition was used is taken for that use placed anew
     */
    static Node of(Node written, Output out, Form before, Form now, boolean movesInstances) {
        Reconciled reconciled = new Reconciled(written.origin(), movesInstances);
        Form plain = Form.parse(out.text());
        reconciled.number(plain, out.lines(), out.owners(), 0);
        return reconciled.node(written, plain, before, now);
    }

    private int number(Form form, Node[] lines, Node[] owner, int first) {
        stemming.put(form, lines[first]);
        owners.put(form, owner[first]);
        int next = first + 1;
        for (Form child : form.body().children()) {
            next = number(child, lines, owner, next);
        }
        return next;
    }

    private Node node(Node written, Form plain, Form before, Form now) {
        return new Node(now.body().name(), attributes(written, before, now), children(written, plain, before, now),
                before.body().content().equals(now.body().content()) ? written.content() : now.body().content(), origin, written.at());
    }

    private static List<Attr> attributes(Node written, Form before, Form now) {
        Map<String, String> old = before.body().attributes();
        Map<String, String> fresh = new LinkedHashMap<>(now.body().attributes());
        fresh.remove("xmlns");
        List<Attr> attributes = new ArrayList<>();
        for (Attr one : written.attributes()) {
            String value = fresh.remove(one.name());
            if (Objects.equals(value, old.get(one.name()))) {
                attributes.add(one);
            } else if (value != null) {
                attributes.add(one.template().isEmpty() ? plain(one.name(), value) : changed(one, old.getOrDefault(one.name(), ""), value));
            }
        }
        fresh.forEach((name, value) -> {
            if (!value.equals(old.get(name))) {
                attributes.add(plain(name, value));
            }
        });
        return attributes;
    }

    /** The numbers that have stayed keep their formulas. */
    private static Attr changed(Attr written, String old, String now) {
        String raw = Tokens.of(written.raw()).changed(Tokens.of(old), Tokens.of(now));
        return new Attr(written.name(), raw, Template.isIn(raw) ? Optional.of(Template.of(Raw.text(raw))) : Optional.empty(), -1, -1);
    }

    private static Attr plain(String name, String raw) {
        return new Attr(name, raw, Optional.empty(), -1, -1);
    }

    private List<Node> children(Node written, Form plain, Form before, Form now) {
        List<Form> olds = before.body().children();
        List<Form> nows = now.body().children();
        int[] fates = new int[olds.size()];
        Arrays.fill(fates, -1);
        int[] origins = Alignment.of(olds, nows);
        for (int j = 0; j < origins.length; j++) {
            if (origins[j] >= 0) {
                fates[origins[j]] = j;
            }
        }
        IdentityHashMap<Node, List<Form>> runs = new IdentityHashMap<>();
        IdentityHashMap<Form, Integer> places = places(plain.body().children(), olds);
        plain.body().children().forEach(one -> runs.computeIfAbsent(owners.get(one), owner -> new ArrayList<>()).add(one));
        List<Kept> kept = new ArrayList<>();
        for (Node child : written.children()) {
            kept.addAll(child(child, runs.getOrDefault(child, List.of()), places, fates, olds, nows));
        }
        for (int j = 0; j < nows.size(); j++) {
            if (origins[j] < 0) {
                add(kept, new Kept(node(nows.get(j)), j));
            }
        }
        return kept.stream().map(Kept::node).toList();
    }

    /** What comes new comes behind what comes before it. */
    private static void add(List<Kept> kept, Kept fresh) {
        int at = kept.size();
        for (int i = 0; i < kept.size(); i++) {
            at = kept.get(i).number == fresh.number - 1 ? i + 1 : at;
        }
        kept.add(at, fresh);
    }

    /** Which of the elements in canonical order each is: those of one name keep their order. */
    private static IdentityHashMap<Form, Integer> places(List<Form> plain, List<Form> canonical) {
        Map<String, List<Integer>> free = new LinkedHashMap<>();
        for (int i = 0; i < canonical.size(); i++) {
            free.computeIfAbsent(canonical.get(i).body().name(), name -> new ArrayList<>()).add(i);
        }
        Map<String, Integer> taken = new LinkedHashMap<>();
        IdentityHashMap<Form, Integer> places = new IdentityHashMap<>();
        for (Form one : plain) {
            String name = one.body().name();
            List<Integer> all = free.getOrDefault(name, List.of());
            int next = taken.merge(name, 1, Integer::sum) - 1;
            if (next < all.size()) {
                places.put(one, all.get(next));
            }
        }
        return places;
    }

    private List<Kept> child(Node child, List<Form> run, IdentityHashMap<Form, Integer> places, int[] fates, List<Form> olds, List<Form> nows) {
        int last = -2;
        boolean isSame = true;
        for (Form one : run) {
            Integer place = places.get(one);
            int fate = place == null ? -2 : fates[place];
            isSame &= place == null || (fate >= 0 && olds.get(place).equals(nows.get(fate)));
            last = fate >= 0 ? fate : last;
        }
        if (isSame) {
            return List.of(new Kept(child, last));
        }
        Form first = run.get(0);
        int place = places.getOrDefault(first, -1);
        boolean isOne = run.size() == 1 && place >= 0 && fates[place] >= 0;
        if (isOne && child.equals(stemming.get(first)) && first.body().name().equals(child.name())) {
            return List.of(new Kept(node(child, first, olds.get(place), nows.get(fates[place])), last));
        }
        if (isOne && movesInstances && child.name().equals(Node.INSTANCE)) {
            Optional<Node> moved = instance(child, olds.get(place), nows.get(fates[place]));
            if (moved.isPresent()) {
                return List.of(new Kept(moved.get(), last));
            }
        }
        List<Kept> written = new ArrayList<>();
        for (Form one : run) {
            Integer at = places.get(one);
            if (at != null && fates[at] >= 0) {
                written.add(new Kept(node(nows.get(fates[at])), fates[at]));
            }
        }
        return written;
    }

    /** The use of a definition, if nothing but what it says itself has changed. */
    private Optional<Node> instance(Node child, Form before, Form now) {
        Map<String, String> old = new LinkedHashMap<>(before.body().attributes());
        Map<String, String> fresh = new LinkedHashMap<>(now.body().attributes());
        old.keySet().removeAll(OF_INSTANCE);
        fresh.keySet().removeAll(OF_INSTANCE);
        boolean isOwn = old.equals(fresh) && before.body().children().equals(now.body().children()) && before.body().name().equals(now.body().name());
        return isOwn ? Optional.of(new Node(child.name(), attributes(child, before, now), child.children(), child.content(), origin, child.at())) : Optional.empty();
    }

    private Node node(Form form) {
        Form.Body body = form.body();
        return new Node(body.name(), body.attributes().entrySet().stream().map(one -> plain(one.getKey(), one.getValue())).toList(),
                body.children().stream().map(this::node).toList(), body.content(), origin, 0);
    }
}
