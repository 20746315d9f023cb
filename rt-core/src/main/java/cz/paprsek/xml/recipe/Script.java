package cz.paprsek.xml.recipe;

import cz.paprsek.formula.Formula;
import cz.paprsek.formula.Function;
import cz.paprsek.formula.Maker;
import cz.paprsek.formula.Written;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Scene.Recipe;
import cz.paprsek.scene.Scene.Recipe.Parameter;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.text.Numbers;
import cz.paprsek.text.Similar;
import cz.paprsek.xml.format.SceneFormat;
import cz.paprsek.xml.mistake.Problems;
import cz.paprsek.xml.recipe.Names.Param;
import cz.paprsek.xml.recipe.Names.ToldAlready;
import cz.paprsek.xml.recipe.Node.Attr;
import cz.paprsek.xml.text.Form;
import cz.paprsek.xml.text.Places.Place;
import cz.paprsek.xml.text.Unpatchable;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/** A file whose scenes are made, and what has come of it. */
public final class Script {
    /** One of these words is in every file that is to be written out, or a brace. */
    private static final List<byte[]> WORDS = Node.NAMES.stream().map(word -> word.getBytes(StandardCharsets.US_ASCII)).toList();

    private final Output out = new Output();
    private final Mistakes mistakes = new Mistakes();
    private final List<Recipe> recipes = new ArrayList<>();
    private final Map<String, String> given;
    private final Moment moment;
    private final Set<String> used = new TreeSet<>();
    private final Set<String> known = new TreeSet<>();
    private final Set<String> defined = new TreeSet<>();
    private final IncludedFiles files;
    private final long mostCharacters;
    private @Nullable Node only;
    private @Nullable Names names;

    private Script(Map<String, String> given, Moment moment, IncludedFiles files, long mostCharacters) {
        this.given = given;
        this.moment = moment;
        this.files = files;
        this.mostCharacters = mostCharacters;
    }

    /**
     * Something wrong with the file, or with one that it includes.
     *
     * @param line from 1
     * @param column from 1
     */
    public record Wrong(String file, int line, int column, String message) {
        public Wrong {
            Objects.requireNonNull(file, "file");
            Objects.requireNonNull(message, "message");
        }
    }

    /** Whether a file has anything that must be looked at here; if not, it is as all others. */
    public static boolean mayBeIn(byte[] file) {
        for (int at = 0; at < file.length; at++) {
            byte c = file[at];
            if (c == '{') {
                return true;
            }
            if (c == 'r' || c == 'i' || c == 'p' || c == 'd') {
                for (byte[] word : WORDS) {
                    if (c == word[0] && at + word.length <= file.length && Arrays.equals(file, at, at + word.length, word, 0, word.length)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    static boolean isName(String name) {
        return name.matches("[A-Za-z_][A-Za-z0-9_]*") && !name.equals("pi") && !Function.words().contains(name) && !Set.of("and", "or", "not").contains(name);
    }

    /**
     * Writes the scenes of a file out.
     *
     * @param utf8 well-formed XML
     * @param file its name, for messages
     * @param given values of parameters that are to have others than the file says
     * @param moment the time that formulas know
     * @param mostCharacters how long what is written may become
     * @return empty if there is nothing to be written out, or it is no scene file
     */
    public static Optional<Script> of(byte[] utf8, String file, Map<String, String> given, Moment moment, IncludedFiles files, long mostCharacters) {
        return of(utf8, file, given, moment, files, mostCharacters, false);
    }

    /** As the other, also of a scene with nothing to be written out. */
    public static Optional<Script> ofAny(byte[] utf8, IncludedFiles files, long mostCharacters) {
        return of(utf8, "scene", Map.of(), Moment.REST, files, mostCharacters, true);
    }

    private static Optional<Script> of(byte[] utf8, String file, Map<String, String> given, Moment moment, IncludedFiles files, long mostCharacters, boolean isAny) {
        Objects.requireNonNull(file, "file");
        Objects.requireNonNull(moment, "moment");
        Objects.requireNonNull(files, "files");
        Script script = new Script(Map.copyOf(given), moment, files, mostCharacters);
        try {
            Node root = NodeReader.read(utf8, file, script.mistakes::add);
            if (root.isPlain() && script.mistakes.isEmpty() && given.isEmpty() && !isAny) {
                return Optional.empty();
            }
            script.run(root);
        } catch (Problems.Stop enough) {
            // What there is to tell stands in the mistakes.
        } catch (Unpatchable noScene) {
            return Optional.empty();
        }
        return Optional.of(script);
    }

    private void run(Node root) {
        if (root.name().equals("database")) {
            out.open("database", root, root, root);
            out.attribute("xmlns", SceneFormat.NAMESPACE);
            root.attributes().forEach(one -> out.attribute(one.name(), one.raw()));
            for (Node scene : root.children()) {
                scene(scene, false);
            }
            out.close("database");
        } else {
            scene(root, true);
        }
        for (String name : given.keySet()) {
            if (!used.contains(name)) {
                mistakes.add(root, "there is no parameter \"" + name + "\"" + (known.isEmpty() ? " here, nor any other" : Similar.suggestion(name, known).isEmpty()
                        ? "; there is " + String.join(", ", known.stream().limit(10).toList()) : Similar.suggestion(name, known)));
            }
        }
    }

    private void scene(Node written, boolean isRoot) {
        Ingredients found = new Ingredients(written, files, mistakes, given, moment);
        used.addAll(found.used());
        known.addAll(found.names().params().keySet());
        List<Parameter> parameters = new ArrayList<>();
        found.names().params().forEach((name, param) -> parameter(name, param, found.names()).ifPresent(parameters::add));
        Node scene = found.scene();
        only = scene;
        names = found.names();
        defined.addAll(found.definitions().keySet());
        scene.children().forEach(child -> checkAnimated(child, found.names().params().keySet(), parameters));
        new Expansion(scene, out, found.names(), found.definitions(), found.materials(), mistakes, mostCharacters).scene(scene, isRoot);
        recipes.add(scene.isPlain() ? Recipe.NONE : new Recipe(NodeText.of(scene), found.included(), parameters));
    }

    private void checkAnimated(Node child, Set<String> params, List<Parameter> ranges) {
        if (child.isOfParameter()) {
            String name = child.attribute("target").orElseThrow().text().substring(Animation.PARAMETER.length());
            if (!params.contains(name)) {
                mistakes.add(child, "target", "there is no parameter \"" + name + "\"" + Similar.suggestion(name, params));
            }
            ranges.stream().filter(one -> one.name().equals(name)).forEach(one -> child.children().forEach(key -> checkKey(key, one)));
        }
    }

    private void checkKey(Node key, Parameter animated) {
        String value = key.attribute("value").map(Attr::text).orElse("").strip();
        double number = Numbers.parsed(value).orElse(Double.NaN);
        if (number < animated.least().orElse(number) || number > animated.most().orElse(number)) {
            mistakes.add(key, "value", outside(animated.name(), animated.least(), animated.most(), value));
        }
    }

    private static String outside(String name, OptionalDouble least, OptionalDouble most, String value) {
        String range = least.isPresent() && most.isPresent() ? " from " + Numbers.text(least.getAsDouble()) + " to " + Numbers.text(most.getAsDouble())
                : least.isPresent() ? ", " + Numbers.text(least.getAsDouble()) + " or above" : most.isPresent() ? ", " + Numbers.text(most.getAsDouble()) + " at most" : "";
        return "the parameter \"" + name + "\" must be a number" + range + ", but is " + (value.isEmpty() ? "empty" : value);
    }

    private Optional<Parameter> parameter(String name, Param param, Names names) {
        try {
            names.known(name);
            OptionalDouble least = bound(param, "min", names);
            OptionalDouble most = bound(param, "max", names);
            OptionalDouble step = bound(param, "step", names);
            if (least.isPresent() && most.isPresent() && least.getAsDouble() > most.getAsDouble()) {
                mistakes.add(param.node(), "max", "max must be at least min, which is " + Numbers.text(least.getAsDouble()) + ", but is " + Numbers.text(most.getAsDouble()));
                return Optional.empty();
            }
            boolean isWithin = param.number().isEmpty() || (param.number().getAsDouble() >= least.orElse(-Double.MAX_VALUE) && param.number().getAsDouble() <= most.orElse(Double.MAX_VALUE));
            boolean isNumber = param.number().isPresent() || (least.isEmpty() && most.isEmpty() && step.isEmpty());
            if (!isWithin || !isNumber) {
                mistakes.add(param.node(), "value", outside(name, least, most, param.text()));
                return Optional.empty();
            }
            return Optional.of(new Parameter(name, param.node().attribute("value").map(Attr::text).orElse(""), param.text(), least, most, step));
        } catch (ToldAlready told) {
            return Optional.empty();
        }
    }

    private OptionalDouble bound(Param param, String attribute, Names names) {
        Optional<Attr> given = param.node().attribute(attribute);
        if (given.isEmpty()) {
            return OptionalDouble.empty();
        }
        try {
            String text = given.get().template().isPresent() ? given.get().template().get().value(names) : given.get().text();
            return OptionalDouble.of(Formula.value(text));
        } catch (Template.Misplaced why) {
            mistakes.add(param.node(), given.get(), why);
        } catch (IllegalArgumentException none) {
            mistakes.add(param.node(), attribute, attribute + " must be a number, but is \"" + given.get().text() + "\"");
        }
        throw new ToldAlready();
    }

    /**
     * The text of the scene, for a file, with what has become of it.
     *
     * @param before the one scene of this file as it is written canonically without formulas
     * @param now what that has become
     * @param movesInstances as in {@link Reconciled}
     */
    public String reconciled(Form before, Form now, boolean movesInstances) {
        return NodeText.of(new Reconciled(Objects.requireNonNull(only), out, movesInstances, Reconciled.Copying.NONE).of(before, now));
    }

    /**
     * As the other, but what has become of a first copy becomes of all copies.
     *
     * @param isOfEach whether what each copy has of its own, by a formula, may be changed too, into the same for all
     * @return empty if nothing that is repeated has been changed
     * @throws IllegalArgumentException if each copy has of its own what has been changed, and may not
     */
    public Optional<String> following(Form before, Form now, boolean isOfEach) {
        Reconciled all = new Reconciled(Objects.requireNonNull(only), out, true, isOfEach ? Reconciled.Copying.OF_EACH : Reconciled.Copying.ALIKE);
        Node scene = all.of(before, now);
        return all.isFollowed() ? Optional.of(NodeText.of(scene)) : Optional.empty();
    }

    /** What makes bodies of the scene of this file. */
    public List<Maker> makers() {
        return Makers.of(Objects.requireNonNull(only), out);
    }

    /** The text of the scene with another value of an attribute of one of its {@link #makers()}; without it for none. */
    public String with(int maker, String attribute, String value) {
        Node scene = Objects.requireNonNull(only);
        Node node = Makers.nodes(scene).get(maker);
        IdentityHashMap<Node, List<Node>> others = new IdentityHashMap<>();
        others.put(node, List.of(Rewritten.with(node, attribute, value)));
        return NodeText.of(Rewritten.of(scene, others));
    }

    /**
     * The text of the scene with an element around bodies that stand beside each other.
     *
     * @param bodies by their numbers, as in {@link Maker}
     * @throws IllegalArgumentException if they do not stand beside each other, or are no elements of the file
     */
    public String around(List<List<Integer>> bodies, String element, Map<String, String> attributes) {
        Node scene = Objects.requireNonNull(only);
        Map<List<Integer>, Node> sites = Makers.sites(out);
        List<Node> nodes = new ArrayList<>();
        for (List<Integer> body : bodies) {
            Node node = sites.get(body);
            if (node != null && !nodes.contains(node)) {
                nodes.add(node);
            }
        }
        if (nodes.isEmpty() || !Rewritten.areSiblings(scene, nodes)) {
            throw new IllegalArgumentException("what is to be repeated must stand side by side, in the scene or in one operation");
        }
        return NodeText.of(Rewritten.around(scene, nodes, element, attributes));
    }

    /**
     * The text of the scene with a definition of a body, which is used where the body stands.
     *
     * @param body by its numbers, as in {@link Maker}
     * @param wanted what the definition is called, unless there is one of that name; then it has a number as well
     * @param isMoved whether the definition stands at the origin, and its use where the body stood
     * @throws IllegalArgumentException if the body is no element of the file
     */
    public String defined(List<Integer> body, String wanted, boolean isMoved) {
        Node scene = Objects.requireNonNull(only);
        Map<List<Integer>, Node> sites = Makers.sites(out);
        Node node = sites.get(body);
        if (node == null || (body.size() > 1 && node.equals(sites.get(body.subList(0, body.size() - 1)))) || !Rewritten.holds(scene, node)) {
            throw new IllegalArgumentException("this body is made by a definition, and cannot be one of its own");
        }
        String name = wanted;
        for (int i = 2; defined.contains(name); i++) {
            name = wanted + "-" + i;
        }
        return NodeText.of(Rewritten.defined(scene, node, name, isMoved ? Rewritten.OF_USE : Set.of("name")));
    }

    /**
     * The text of the scene with another use of a definition after one of its {@link #makers()}, without its name, so far from it along x.
     *
     * @throws IllegalArgumentException if that is no use of a definition, or stands where a formula says to which nothing can be added
     */
    public String usedAgain(int maker, double aside) {
        Node scene = Objects.requireNonNull(only);
        List<Node> makers = Makers.nodes(scene);
        if (maker < 0 || maker >= makers.size() || !makers.get(maker).name().equals(Node.INSTANCE)) {
            throw new IllegalArgumentException("there is no use of a definition with the number " + maker);
        }
        Node node = makers.get(maker);
        IdentityHashMap<Node, List<Node>> others = new IdentityHashMap<>();
        // Behind all others, whose numbers stay.
        Node last = siblings(scene, node).stream().filter(Node::isBody).reduce((first, second) -> second).orElse(node);
        others.put(last, List.of(last, Rewritten.with(Rewritten.with(node, "position", beside(node, aside)), "name", "")));
        return NodeText.of(Rewritten.of(scene, others));
    }

    /** Where an element stands, as it is written, but so far from there along x. */
    private String beside(Node node, double aside) {
        String written = node.attribute("position").map(Attr::text).orElse("0 0 0");
        Optional<String> moved = Aside.of(written, aside);
        return moved.or(() -> node.attribute("position").flatMap(Attr::template).flatMap(this::valueOf).flatMap(value -> Aside.of(value, aside)))
                .orElseThrow(() -> new IllegalArgumentException("where this is, \"" + written + "\" says, to which nothing can be added; write its x as one formula in braces"));
    }

    private Optional<String> valueOf(Template template) {
        try {
            return Optional.of(template.value(Objects.requireNonNull(names)));
        } catch (ToldAlready | Template.Misplaced hasNone) {
            return Optional.empty();
        }
    }

    private static List<Node> siblings(Node parent, Node node) {
        return parent.children().contains(node) ? parent.children()
                : parent.children().stream().map(child -> siblings(child, node)).filter(found -> !found.isEmpty()).findFirst().orElse(List.of());
    }

    /**
     * What a formula comes to in the scene of this file.
     *
     * @param firsts names that number copies, if it stands in what is repeated: it is that of the first of all copies
     * @throws cz.paprsek.formula.FormulaException if it is none, or has no value
     */
    public double value(String formula, Set<String> firsts) {
        Names all = Objects.requireNonNull(names);
        firsts.forEach(name -> all.bind(name, 0));
        try {
            return Formula.of(formula).value(all);
        } catch (ToldAlready hasNone) {
            throw new IllegalArgumentException("a parameter in it has no value", hasNone);
        } finally {
            firsts.forEach(name -> all.unbind());
        }
    }

    /** What a formula comes to where there are no parameters. */
    public static double valueOfPlain(String formula) {
        return Formula.of(formula).value(new Names((param, why) -> {}, Moment.REST));
    }

    /** Where formulas stand in what is written out, by what has them; without a place, those of the scene itself and of what there is once in it. */
    public Map<Optional<ScenePath>, List<Written>> formulas() {
        return WrittenFormulas.of(out);
    }

    /** Where in this file what is in the scene stands, in bytes, by what it is: not what comes of files that are included. */
    public Map<ScenePath, Integer> sites() {
        return Sites.of(Objects.requireNonNull(only), out);
    }

    /** What is wrong; then there is no text. */
    public List<Wrong> mistakes() {
        return mistakes.found().stream().map(one -> new Wrong(one.file(), one.line(), one.column(), one.message())).toList();
    }

    /** The file without anything that has to be written out. */
    public byte[] text() {
        return out.bytes();
    }

    /** How each of its scenes is made. */
    public List<Recipe> recipes() {
        return List.copyOf(recipes);
    }

    /**
     * Says of a mistake in the {@link #text} where in the file it is.
     *
     * @param line of the text, from 1
     * @param attributes of these the first that the element there has is at fault
     */
    public Wrong wrong(int line, String message, List<String> attributes) {
        Node[] lines = out.lines();
        Node node = lines[Math.max(1, Math.min(lines.length, line)) - 1];
        Optional<Attr> fault = attributes.stream().flatMap(name -> node.attribute(name).stream()).filter(one -> one.nameAt() >= 0).findFirst();
        Place place = node.origin().place(fault.map(Attr::nameAt).orElse(node.at()));
        return new Wrong(node.origin().file(), place.line(), place.column(), message);
    }
}
