package cz.paprsek.xml.recipe;

import cz.paprsek.text.Similar;
import cz.paprsek.xml.recipe.Names.Param;
import cz.paprsek.xml.recipe.Node.Attr;
import cz.paprsek.xml.text.Unpatchable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** What a scene is made of: its own parameters and definitions, and those from files that it includes, with their materials. */
final class Ingredients {
    private static final Set<String> OF_PARAM = Set.of("name", "value", "min", "max", "step");

    private final Mistakes mistakes;
    private final IncludedFiles files;
    private final Map<String, String> given;
    private final Node scene;
    private final List<Node> overriding = new ArrayList<>();
    private final Names names;
    private final Map<String, Node> definitions = new LinkedHashMap<>();
    private final List<Node> materials = new ArrayList<>();
    private final Map<String, String> included = new LinkedHashMap<>();
    private final Deque<String> open = new ArrayDeque<>();
    private final Set<String> used = new TreeSet<>();

    Ingredients(Node written, IncludedFiles files, Mistakes mistakes, Map<String, String> given, Moment moment) {
        this.files = files;
        this.mistakes = mistakes;
        this.given = given;
        names = new Names((param, why) -> mistakes.add(param.node(), param.node().attribute("value").orElseThrow(), why), moment);
        scene = withGiven(written);
        // Its own parameters win over those that come along.
        scene.children().stream().filter(one -> one.name().equals(Node.PARAM)).forEach(one -> param(one, true));
        scene.children().stream().filter(one -> one.name().equals(Node.DEFINE)).forEach(this::define);
        scene.children().stream().filter(one -> one.name().equals(Node.INCLUDE)).forEach(one -> include(one, ""));
    }

    /** The scene as it is written, its parameters as they are given. */
    Node scene() {
        if (overriding.isEmpty()) {
            return scene;
        }
        List<Node> children = new ArrayList<>(overriding);
        children.addAll(scene.children());
        return new Node(scene.name(), scene.attributes(), children, scene.content(), scene.origin(), scene.at());
    }

    Names names() {
        return names;
    }

    Map<String, Node> definitions() {
        return definitions;
    }

    /** Those that come along. */
    List<Node> materials() {
        return materials;
    }

    /** The texts of the files that are included, by their names. */
    Map<String, String> included() {
        return included;
    }

    /** The names of those parameters given that there are. */
    Set<String> used() {
        return used;
    }

    private Node withGiven(Node written) {
        if (given.isEmpty()) {
            return written;
        }
        return new Node(written.name(), written.attributes(), written.children().stream().map(this::given).toList(), written.content(), written.origin(), written.at());
    }

    private Node given(Node child) {
        String value = child.name().equals(Node.PARAM) ? given.get(child.attribute("name").map(Attr::text).orElse("")) : null;
        if (value == null) {
            return child;
        }
        used.add(child.attribute("name").orElseThrow().text());
        List<Attr> attributes = new ArrayList<>();
        Attr now = attribute(child, value);
        child.attributes().forEach(one -> attributes.add(one.name().equals("value") ? now : one));
        if (child.attribute("value").isEmpty()) {
            attributes.add(now);
        }
        return new Node(child.name(), attributes, child.children(), child.content(), child.origin(), child.at());
    }

    private Attr attribute(Node child, String value) {
        Optional<Template> template = Optional.empty();
        if (Template.isIn(value)) {
            try {
                template = Optional.of(Template.of(value));
            } catch (Template.Misplaced wrong) {
                mistakes.add(child, String.valueOf(wrong.getMessage()));
            }
        }
        int at = child.attribute("value").map(Attr::nameAt).orElse(-1);
        return new Attr("value", Raw.of(value), template, at, -1);
    }

    private void param(Node written, boolean isOwn) {
        Node param = isOwn ? written : given(written);
        if (!check(param, OF_PARAM)) {
            return;
        }
        String name = param.attribute("name").map(Attr::text).orElse("");
        if (!Script.isName(name) || Names.isTaken(name)) {
            mistakes.add(param, "name", "a parameter needs a name of letters, digits and _ that stands for nothing else in formulas"
                    + (name.isEmpty() ? "" : ", but has \"" + name + "\""));
        } else if (param.attribute("value").isEmpty()) {
            mistakes.add(param, "the parameter \"" + name + "\" needs the attribute \"value\"");
        } else if (!names.params().containsKey(name)) {
            names.params().put(name, new Param(param));
            if (!param.equals(written) && !isOwn) {
                overriding.add(param);
            }
        } else if (isOwn || names.params().get(name).node().origin() != scene.origin()) {
            mistakes.add(param, "name", "there is a parameter \"" + name + "\" already");
        }
    }

    private void define(Node define) {
        if (!check(define, Set.of("name"))) {
            return;
        }
        String name = define.attribute("name").map(Attr::text).orElse("");
        if (name.isBlank()) {
            mistakes.add(define, "a definition needs a name");
        } else if (define.children().size() != 1 || !define.children().get(0).isBody()) {
            mistakes.add(define, "a definition has one body inside, but \"" + name + "\" has " + (define.children().size() == 1
                    ? "<" + define.children().get(0).name() + ">" : String.valueOf(define.children().size())));
        } else if (definitions.putIfAbsent(name, define.children().get(0)) != null) {
            mistakes.add(define, "name", "there is a definition \"" + name + "\" already");
        }
    }

    private void include(Node include, String folder) {
        if (!check(include, Set.of("file"))) {
            return;
        }
        String file = include.attribute("file").map(Attr::text).orElse("");
        String name = folder + file;
        if (file.isBlank()) {
            mistakes.add(include, "<include> needs the attribute \"file\"");
            return;
        }
        if (open.contains(name)) {
            mistakes.add(include, "file", "\"" + name + "\" includes itself");
            return;
        }
        if (included.containsKey(name)) {
            return;
        }
        try {
            byte[] text = files.read(name);
            included.put(name, new String(text, StandardCharsets.UTF_8));
            open.addLast(name);
            bring(NodeReader.read(text, files.called(name).orElseGet(() -> seenFrom(include, file)), mistakes::add), include, name.substring(0, name.lastIndexOf('/') + 1));
            open.removeLast();
        } catch (IOException unreadable) {
            mistakes.add(include, "file", String.valueOf(unreadable.getMessage()));
        } catch (Unpatchable noScene) {
            mistakes.add(include, "file", "\"" + name + "\" is no scene file");
        }
    }

    /** How messages call a file beside another. */
    private static String seenFrom(Node include, String file) {
        String from = include.origin().file().replace('\\', '/');
        return from.substring(0, from.lastIndexOf('/') + 1) + file;
    }

    private void bring(Node from, Node include, String folder) {
        if (!from.name().equals("scene")) {
            mistakes.add(include, "file", "a scene is included, not a <" + from.name() + ">");
            return;
        }
        for (Node one : from.children()) {
            switch (one.name()) {
                case Node.PARAM -> param(one, false);
                case Node.DEFINE -> define(one);
                case Node.INCLUDE -> include(one, folder);
                case "material" -> materials.add(one);
                default -> {
                    // What else there is in it is its own scene.
                }
            }
        }
    }

    private boolean check(Node node, Set<String> known) {
        for (Attr one : node.attributes()) {
            if (!known.contains(one.name())) {
                mistakes.add(node, one.name(), "<" + node.name() + "> has no attribute \"" + one.name() + "\"" + Similar.suggestion(one.name(), known));
                return false;
            }
        }
        return true;
    }
}
