package cz.paprsek.xml.recipe;

import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Placement;
import cz.paprsek.text.Numbers;
import cz.paprsek.text.Similar;
import cz.paprsek.xml.format.SceneFormat;
import cz.paprsek.xml.recipe.Names.ToldAlready;
import cz.paprsek.xml.recipe.Node.Attr;
import cz.paprsek.xml.recipe.Template.Misplaced;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Stream;

/** Writes a scene out: every formula as its value, every copy as an element of its own. */
final class Expansion {
    private static final Set<String> PLACEMENT = Set.of("position", "rotation", "scale");
    /** What a repeat or an instance says in place of its bodies. */
    private static final List<String> INSTEAD = List.of("pivot", "hidden");
    static final String INDEX = "i";

    private final Output out;
    private final Names names;
    private final Map<String, Node> definitions;
    private final List<Node> brought;
    private final Mistakes mistakes;
    private final Copies copies;
    /** The definitions that are being written out, each within the one before. */
    private final Deque<String> open = new ArrayDeque<>();
    /** What is being written is there for this element of the file. */
    private Node owner;
    /** The use of a definition, outermost, that is being written. */
    private Node site;

    /**
     * What writes scenes out.
     *
     * @param scene the one that is to be written
     * @param definitions the bodies by the names of their definitions
     * @param brought elements from files that are included
     * @param mostCharacters of all that is written
     */
    Expansion(Node scene, Output out, Names names, Map<String, Node> definitions, List<Node> brought, Mistakes mistakes, long mostCharacters) {
        owner = scene;
        site = scene;
        this.out = out;
        this.names = names;
        this.definitions = definitions;
        this.brought = brought;
        this.mistakes = mistakes;
        copies = new Copies(out, mistakes, mostCharacters);
    }

    /**
     * What is around a body.
     *
     * @param placement of the copy that it is
     * @param name what it is called if it has no name, or in its place, as {@code isRenamed} says
     * @param suffix behind its name
     * @param made what gives it a material if it has none: an element with one; empty for nothing
     * @param instead attributes, as they are written out, that count in place of its own
     */
    private record Around(Placement placement, String name, boolean isRenamed, String suffix, Optional<Node> made, Map<String, String> instead, boolean isOperand) {
        static final Around SCENE = new Around(Placement.NONE, "", false, "", Optional.empty(), Map.of(), false);
        static final Around OPERATION = new Around(Placement.NONE, "", false, "", Optional.empty(), Map.of(), true);
    }

    void scene(Node scene, boolean isRoot) {
        out.open("scene", scene, scene, scene);
        if (isRoot) {
            out.attribute("xmlns", SceneFormat.NAMESPACE);
        }
        scene.attributes().forEach(one -> out.attribute(one, raw(scene, one)));
        out.content(scene.content());
        brought.forEach(material -> guarded(() -> owned(material, () -> plain(material))));
        Ahead.tooMany(scene, names, definitions).ifPresent(child -> {
            throw copies.tooMany(child);
        });
        for (Node child : scene.children()) {
            guarded(() -> owned(child, () -> child(child, Around.SCENE)));
        }
        out.close("scene");
    }

    private static void guarded(Runnable step) {
        try {
            step.run();
        } catch (ToldAlready told) {
            // And the next one may still be looked at.
        }
    }

    private void child(Node node, Around around) {
        switch (node.name()) {
            case Node.REPEAT -> repeat(node, around);
            case Node.INSTANCE -> instance(node, around);
            case Node.PARAM, Node.DEFINE, Node.INCLUDE -> {
                if (!around.equals(Around.SCENE)) {
                    throw wrong(node, "<" + node.name() + "> stands directly in a scene, not within a body");
                }
            }
            default -> {
                if (node.isBody()) {
                    body(node, around);
                } else {
                    plain(node);
                }
            }
        }
    }

    private void plain(Node node) {
        out.open(node.name(), node, owner, owner);
        node.attributes().forEach(one -> out.attribute(one, raw(node, one)));
        out.content(node.content());
        node.children().forEach(one -> owned(one, () -> plain(one)));
        out.close(node.name());
    }

    /** Writes what is there for an element of the file. */
    private void owned(Node now, Runnable writing) {
        Node around = owner;
        owner = now;
        try {
            writing.run();
        } finally {
            owner = around;
        }
    }

    private void repeat(Node repeat, Around around) {
        check(repeat, Set.of("name", "count", "index", "position", "rotation", "scale", "pivot", "hidden", "material"));
        int count = count(repeat);
        out.counted(repeat, count);
        Composed.Steps steps = new Composed.Steps(placement(repeat));
        String index = repeat.attribute("index").map(Attr::text).orElse(INDEX);
        if (!Script.isName(index)) {
            throw wrong(repeat, "index", "the number of a copy must have a name of letters, digits and _, but has \"" + index + "\"");
        }
        List<Node> bodies = repeat.children().stream().filter(one -> !one.name().equals("material")).toList();
        if (bodies.isEmpty()) {
            throw wrong(repeat, "a repeat needs a body inside");
        }
        for (Node one : bodies) {
            if (!one.isBody()) {
                throw wrong(one, "<repeat> repeats bodies, and <" + one.name() + "> is none");
            }
        }
        Optional<Node> made = isMade(repeat) ? Optional.of(repeat) : around.made;
        if (around.isOperand) {
            if (count == 0) {
                throw wrong(repeat, "count", "a repeat in an operation needs a copy at least, but its count is 0");
            }
            // One solid, wherever it stands.
            out.open("union", repeat, owner, site(repeat));
            nameAndPlace(name(repeat, around), around.placement);
            said(repeat, around).forEach((attribute, value) -> out.attribute(attribute, value));
            made.ifPresent(this::material);
        }
        String given = repeat.attribute("name").map(Attr::text).orElse("");
        for (int i = 0; i < count; i++) {
            Optional<Placement> placement = placed(repeat, () -> {
                Optional<Placement> step = steps.next();
                return step.isEmpty() || around.isOperand ? step : Composed.of(around.placement, step.get());
            });
            if (placement.isEmpty()) {
                throw wrong(repeat, "scale", "what turns its copies must scale them evenly: one number, or three alike");
            }
            String suffix = (around.isOperand ? "" : around.suffix) + "[" + i + "]";
            String name = around.isRenamed && !around.isOperand ? around.name : given;
            names.bind(index, i);
            try {
                for (int k = 0; k < bodies.size(); k++) {
                    copies.next(repeat);
                    String own = name.isEmpty() || bodies.size() == 1 ? name : name + "." + (k + 1);
                    child(bodies.get(k), new Around(placement.get(), own, around.isRenamed && !around.isOperand, suffix, around.isOperand ? Optional.empty() : made,
                            around.isOperand ? Map.of() : said(repeat, around), around.isOperand));
                }
            } finally {
                names.unbind();
            }
        }
        if (around.isOperand) {
            out.close("union");
        }
    }

    /** A placement within another one, which may be too far away, or too large. */
    private Optional<Placement> placed(Node node, Supplier<Optional<Placement>> within) {
        try {
            return within.get();
        } catch (IllegalArgumentException beyond) {
            throw wrong(node, "with what it stands in, its " + beyond.getMessage());
        }
    }

    private int count(Node repeat) {
        Attr given = repeat.attribute("count").orElseThrow(() -> wrong(repeat, "<repeat> needs the attribute \"count\""));
        return copies.count(repeat, Raw.text(raw(repeat, given)));
    }

    private void instance(Node instance, Around around) {
        check(instance, Set.of("name", "of", "position", "rotation", "scale", "pivot", "hidden", "material"));
        String of = instance.attribute("of").map(Attr::text).orElseThrow(() -> wrong(instance, "<instance> needs the attribute \"of\", the name of a definition"));
        Node body = definitions.get(of);
        if (body == null) {
            throw wrong(instance, "of", "there is no definition \"" + of + "\"" + Similar.suggestion(of, definitions.keySet())
                    + (definitions.isEmpty() ? "; <define name=\"" + of + "\"> makes one" : ""));
        }
        if (open.contains(of)) {
            List<String> way = new ArrayList<>(open);
            way.add(of);
            throw wrong(instance, "of", "the definition \"" + of + "\" needs itself: " + String.join(" > ", way.subList(way.indexOf(of), way.size())));
        }
        if (open.size() >= SceneFormat.DEEPEST || out.isTooDeep()) {
            throw wrong(instance, "of", "instances are nested deeper than the " + SceneFormat.DEEPEST + " levels that they may be");
        }
        copies.next(instance);
        Placement own = placement(instance);
        Optional<Placement> placement = placed(instance, () -> Composed.of(around.placement, own));
        if (placement.isEmpty()) {
            throw wrong(instance, "an instance that is turned cannot stand in what is scaled unevenly");
        }
        String given = instance.attribute("name").map(Attr::text).orElse("");
        String name = around.isRenamed ? around.name : !given.isEmpty() ? given : !around.name.isEmpty() ? around.name : around.suffix.isEmpty() ? "" : of;
        Optional<Node> made = isMade(instance) ? Optional.of(instance) : around.made;
        Node outer = site;
        site = site(instance);
        open.addLast(of);
        try {
            child(body, new Around(placement.get(), name, true, around.suffix, made, said(instance, around), around.isOperand));
        } finally {
            open.removeLast();
            site = outer;
        }
    }

    /** What is said in place of bodies by what is around them, or else here. */
    private Map<String, String> said(Node here, Around around) {
        Map<String, String> said = new LinkedHashMap<>();
        for (String name : INSTEAD) {
            here.attribute(name).map(one -> raw(here, one)).ifPresent(value -> said.put(name, value));
        }
        said.putAll(around.instead);
        return said;
    }

    private Node site(Node node) {
        return open.isEmpty() ? node : site;
    }

    private static boolean isMade(Node node) {
        return node.attribute("material").isPresent() || node.children().stream().anyMatch(one -> one.name().equals("material"));
    }

    private void body(Node node, Around around) {
        Optional<Placement> placed = around.placement.equals(Placement.NONE) ? Optional.empty() : placed(node, () -> Composed.of(around.placement, placement(node)));
        boolean isSkew = !around.placement.equals(Placement.NONE) && placed.isEmpty();
        if (isSkew) {
            out.open("union", node, owner, site(node));
            nameAndPlace(name(node, around), around.placement);
        }
        out.open(node.name(), node, isSkew ? node : owner, site(node));
        String name = isSkew ? "" : name(node, around);
        if (!name.isEmpty()) {
            out.attribute("name", Raw.of(name));
        }
        for (Attr one : node.attributes()) {
            boolean isSaid = one.name().equals("name") || (PLACEMENT.contains(one.name()) && placed.isPresent()) || around.instead.containsKey(one.name());
            if (!isSaid) {
                out.attribute(one, raw(node, one));
            }
        }
        placed.ifPresent(this::placement);
        around.instead.forEach((attribute, value) -> out.attribute(attribute, value));
        if (around.made.isPresent() && !isMade(node)) {
            material(around.made.get());
        }
        out.content(node.content());
        for (Node child : node.children()) {
            owned(child, () -> {
                if (node.isOperation()) {
                    child(child, Around.OPERATION);
                } else {
                    plain(child);
                }
            });
        }
        out.close(node.name());
        if (isSkew) {
            out.close("union");
        }
    }

    private String name(Node node, Around around) {
        String own = node.attribute("name").map(Attr::text).orElse("");
        String name = around.isRenamed || own.isEmpty() ? around.name : own;
        return name.isEmpty() ? "" : name + around.suffix;
    }

    private void nameAndPlace(String name, Placement placement) {
        if (!name.isEmpty()) {
            out.attribute("name", Raw.of(name));
        }
        if (!placement.equals(Placement.NONE)) {
            placement(placement);
        }
    }

    /** What a repeat or an instance says of its bodies' material: by name, or inside. */
    private void material(Node from) {
        from.attribute("material").ifPresent(one -> out.attribute("material", raw(from, one)));
        from.children().stream().filter(one -> one.name().equals("material")).forEach(one -> owned(one, () -> plain(one)));
    }

    private void placement(Placement placement) {
        attribute("position", placement.position(), Vec3.ZERO);
        attribute("rotation", placement.rotation(), Vec3.ZERO);
        attribute("scale", placement.scale(), Vec3.ONE);
    }

    private void attribute(String name, Vec3 value, Vec3 standard) {
        if (!value.equals(standard)) {
            out.attribute(name, Numbers.text(value));
        }
    }

    private Placement placement(Node node) {
        Vec3 position = vector(node, "position", Vec3.ZERO, false);
        Vec3 rotation = vector(node, "rotation", Vec3.ZERO, false);
        Vec3 scale = vector(node, "scale", Vec3.ONE, true);
        try {
            return new Placement(position, rotation, scale);
        } catch (IllegalArgumentException refused) {
            throw wrong(node, String.valueOf(refused.getMessage()).startsWith("scale") ? "scale" : "position", String.valueOf(refused.getMessage()));
        }
    }

    private Vec3 vector(Node node, String attribute, Vec3 standard, boolean isOneEnough) {
        Optional<Attr> given = node.attribute(attribute);
        if (given.isEmpty()) {
            return standard;
        }
        String text = Raw.text(raw(node, given.get())).strip();
        double[] numbers = Stream.of(text.split(" +", -1)).map(Numbers::parsed).flatMapToDouble(OptionalDouble::stream).toArray();
        if (numbers.length == text.split(" +", -1).length) {
            if (numbers.length == 1 && isOneEnough) {
                return new Vec3(numbers[0], numbers[0], numbers[0]);
            }
            if (numbers.length == 3) {
                return new Vec3(numbers[0], numbers[1], numbers[2]);
            }
        }
        throw wrong(node, attribute, attribute + " must be " + (isOneEnough ? "one finite number, or three, x y z" : "three finite numbers, x y z") + ", but is \"" + text + "\"");
    }

    /** The value of an attribute as it is written out. */
    private String raw(Node node, Attr attribute) {
        if (attribute.template().isEmpty()) {
            return attribute.raw();
        }
        try {
            return Raw.of(attribute.template().get().value(names));
        } catch (Misplaced why) {
            mistakes.add(node, attribute, why);
            throw new ToldAlready();
        }
    }

    private void check(Node node, Set<String> known) {
        Set<String> seen = new HashSet<>();
        for (Attr one : node.attributes()) {
            if (!known.contains(one.name()) || !seen.add(one.name())) {
                throw wrong(node, one.name(), "<" + node.name() + "> has no attribute \"" + one.name() + "\"" + Similar.suggestion(one.name(), known));
            }
        }
    }

    private ToldAlready wrong(Node node, String message) {
        mistakes.add(node, message);
        return new ToldAlready();
    }

    private ToldAlready wrong(Node node, String attribute, String message) {
        mistakes.add(node, attribute, message);
        return new ToldAlready();
    }
}
