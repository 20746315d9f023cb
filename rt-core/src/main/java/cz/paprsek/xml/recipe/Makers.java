package cz.paprsek.xml.recipe;

import cz.paprsek.formula.Maker;
import cz.paprsek.xml.recipe.Node.Attr;
import cz.paprsek.xml.text.Form;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** Finds out which bodies of a scene have been made by what is repeated, and by the use of definitions. */
final class Makers {
    private final Output out;
    private final IdentityHashMap<Form, Node> stemming = new IdentityHashMap<>();
    private final IdentityHashMap<Form, Node> sites = new IdentityHashMap<>();
    private final IdentityHashMap<Node, Integer> numbers = new IdentityHashMap<>();
    private final List<Maker> found = new ArrayList<>();

    /** A body that has been written out, and where in the scene it stands. */
    private record Placed(Form form, List<Integer> at) {}

    private Makers(Output out) {
        this.out = out;
    }

    /** All there are outside of definitions; of repeats within others those of the first copy. */
    static List<Maker> of(Node scene, Output out) {
        List<Node> nodes = nodes(scene);
        if (nodes.isEmpty()) {
            return List.of();
        }
        Makers makers = new Makers(out);
        for (Node one : nodes) {
            makers.numbers.put(one, makers.numbers.size());
        }
        Form plain = Form.parse(out.text());
        makers.number(plain, 0);
        makers.among(scene, placed(plain, List.of()));
        return makers.found;
    }

    /** The elements that make bodies, in their order. */
    static List<Node> nodes(Node scene) {
        List<Node> nodes = new ArrayList<>();
        for (Node child : scene.children()) {
            if (child.name().equals(Node.REPEAT) || child.name().equals(Node.INSTANCE)) {
                nodes.add(child);
            }
            if (!child.name().equals(Node.DEFINE)) {
                nodes.addAll(nodes(child));
            }
        }
        return nodes;
    }

    /** The elements of the file that bodies stand for, by the numbers of these. */
    static Map<List<Integer>, Node> sites(Output out) {
        Makers makers = new Makers(out);
        Form plain = Form.parse(out.text());
        makers.number(plain, 0);
        Map<List<Integer>, Node> sites = new LinkedHashMap<>();
        makers.collect(placed(plain, List.of()), sites);
        return sites;
    }

    private void collect(List<Placed> bodies, Map<List<Integer>, Node> into) {
        for (Placed one : bodies) {
            into.put(one.at(), Objects.requireNonNull(sites.get(one.form())));
            collect(placed(one.form(), one.at()), into);
        }
    }

    private int number(Form form, int first) {
        stemming.put(form, out.lines()[first]);
        sites.put(form, out.sites()[first]);
        int next = first + 1;
        for (Form child : form.body().children()) {
            next = number(child, next);
        }
        return next;
    }

    private static List<Placed> placed(Form around, List<Integer> at) {
        List<Placed> bodies = new ArrayList<>();
        for (Form child : around.body().children()) {
            if (Form.group(child.body().name()).equals("body")) {
                List<Integer> longer = new ArrayList<>(at);
                longer.add(bodies.size());
                bodies.add(new Placed(child, List.copyOf(longer)));
            }
        }
        return bodies;
    }

    /** Looks through what is in an element of the file, and the bodies that have come of it. */
    private void among(Node around, List<Placed> bodies) {
        for (Node child : around.children()) {
            List<Placed> own = bodies.stream().filter(one -> isWithin(child, Objects.requireNonNull(sites.get(one.form())))).toList();
            if (own.isEmpty()) {
                continue;
            }
            if (child.name().equals(Node.REPEAT)) {
                repeat(child, own);
            } else if (child.name().equals(Node.INSTANCE)) {
                found.add(maker(child, 1, List.of(own.get(0)), own.subList(0, 1), List.of()));
            } else if (child.isOperation()) {
                among(child, placed(own.get(0).form(), own.get(0).at()));
            }
        }
    }

    private void repeat(Node repeat, List<Placed> own) {
        boolean isOne = repeat.equals(stemming.get(own.get(0).form()));
        List<Placed> copies = isOne ? placed(own.get(0).form(), own.get(0).at()) : own;
        int count = Math.max(1, out.count(repeat));
        // Of copies that differ in what they are made of, the first ends nobody knows where.
        int size = copies.size() % count == 0 ? copies.size() / count : copies.size();
        List<Placed> originals = copies.subList(0, size);
        found.add(maker(repeat, count, originals, copies, isOne ? own.get(0).at() : List.of()));
        among(repeat, originals);
    }

    private Maker maker(Node node, int count, List<Placed> originals, List<Placed> copies, List<Integer> whole) {
        Map<String, String> attributes = new LinkedHashMap<>();
        for (Attr one : node.attributes()) {
            attributes.put(one.name(), one.text());
        }
        return new Maker(numbers.getOrDefault(node, -1), node.name(), attributes, count, originals.stream().map(Placed::at).toList(), copies.stream().map(Placed::at).toList(), whole);
    }

    private static boolean isWithin(Node node, Node site) {
        return node.equals(site) || node.children().stream().anyMatch(child -> isWithin(child, site));
    }
}
