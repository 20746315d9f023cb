package cz.paprsek.xml.recipe;

import cz.paprsek.formula.Formula;
import cz.paprsek.xml.recipe.Node.Attr;
import cz.paprsek.xml.text.Alignment;
import cz.paprsek.xml.text.Form;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * What becomes of the elements of a file when what came of them has been changed: formulas stay where their values have stayed, and copies stay repeated if
 * none was touched; what was touched is written down.
 */
final class Reconciled {
    private static final Set<String> PLACEMENT = Set.of("position", "rotation", "scale");
    private static final Set<String> OF_WHOLE = Set.of("pivot", "hidden");
    /** What is not written if nothing else is there. */
    private static final Map<String, String> USUAL = Map.of("position", "0 0 0", "rotation", "0 0 0", "scale", "1 1 1");
    private static final Pattern NUMBERS = Pattern.compile("(\\[\\d+\\])+$");
    private static final Set<String> OF_INSTANCE = Set.of("name", "position", "rotation", "scale", "pivot", "hidden", "material");

    private final IdentityHashMap<Form, Node> stemming = new IdentityHashMap<>();
    private final IdentityHashMap<Form, Node> owners = new IdentityHashMap<>();
    private final IdentityHashMap<Form, Node> sites = new IdentityHashMap<>();
    private final Node written;
    private final Form plain;
    private final boolean movesInstances;
    private final Copying copying;
    private final Origin origin;
    /** The names that number the copies within which one is. */
    private final Deque<String> indices = new ArrayDeque<>();
    private boolean isFollowed;

    /** What becomes of the other copies when one has been changed: nothing; the same, if copies are alike there; the same even if a formula has made them differ. */
    enum Copying { NONE, ALIKE, OF_EACH }

    /** An element, and which of the new ones it is, or the last of them. */
    private record Kept(Node node, int number) {}

    /**
     * What finds out how a scene is to be written.
     *
     * @param written the scene with its formulas
     * @param out what it was written out as
     * @param movesInstances whether what is placed anew where a definition was used is taken for that use placed anew
     * @param copying whether what has become of a first copy is to become of all copies
     */
    Reconciled(Node written, Output out, boolean movesInstances, Copying copying) {
        this.written = written;
        this.origin = written.origin();
        this.movesInstances = movesInstances;
        this.copying = copying;
        plain = Form.parse(out.text());
        number(plain, out.lines(), out.owners(), out.sites(), 0);
    }

    /**
     * The scene as it is to be written.
     *
     * @param before the scene as it is written canonically
     * @param now what that has become
     */
    Node of(Form before, Form now) {
        return node(written, plain, before, now);
    }

    /** Whether all copies have followed one. */
    boolean isFollowed() {
        return isFollowed;
    }

    private int number(Form form, Node[] lines, Node[] owner, Node[] site, int first) {
        stemming.put(form, lines[first]);
        owners.put(form, owner[first]);
        sites.put(form, site[first]);
        int next = first + 1;
        for (Form child : form.body().children()) {
            next = number(child, lines, owner, site, next);
        }
        return next;
    }

    private Node node(Node written, Form plain, Form before, Form now) {
        return new Node(now.body().name(), attributes(written, before, now), children(written, plain, before, now),
                before.body().content().equals(now.body().content()) ? written.content() : now.body().content(), origin, written.at());
    }

    private List<Attr> attributes(Node written, Form before, Form now) {
        Map<String, String> old = before.body().attributes();
        Map<String, String> fresh = new LinkedHashMap<>(now.body().attributes());
        fresh.remove("xmlns");
        List<Attr> attributes = new ArrayList<>();
        for (Attr one : written.attributes()) {
            String value = fresh.remove(one.name());
            if (Objects.equals(value, old.get(one.name()))) {
                attributes.add(one);
            } else if (one.template().isPresent() && (value != null || USUAL.containsKey(one.name()))) {
                String usual = USUAL.getOrDefault(one.name(), "");
                attributes.add(changed(one, old.getOrDefault(one.name(), usual), value == null ? usual : value));
            } else if (value != null) {
                attributes.add(plain(one.name(), value));
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
    private Attr changed(Attr written, String old, String now) {
        String raw = Tokens.of(written.raw()).changed(Tokens.of(old), Tokens.of(now));
        refuseOfEach(written, Tokens.of(written.raw()), Tokens.of(raw));
        return new Attr(written.name(), raw, Template.isIn(raw) ? Optional.of(Template.of(Raw.text(raw))) : Optional.empty(), -1, -1);
    }

    /** One number instead of a formula that says another one for each copy would put all of them into one place. */
    private void refuseOfEach(Attr attribute, Tokens written, Tokens now) {
        for (int i = 0; i < written.texts().size() && !indices.isEmpty() && copying != Copying.OF_EACH; i++) {
            String token = written.texts().get(i);
            if (token.startsWith("{") && !now.texts().contains(token) && Formula.of(Raw.text(token.substring(1, token.length() - 1))).names().stream().anyMatch(indices::contains)) {
                throw new IllegalArgumentException("each copy has a " + attribute.name() + " of its own, by " + Raw.text(token) + "; change that formula instead");
            }
        }
    }

    private static Attr plain(String name, String raw) {
        return new Attr(name, raw, Optional.empty(), -1, -1);
    }

    private List<Node> children(Node written, Form plain, Form before, Form now) {
        Level level = level(plain, before, now);
        IdentityHashMap<Node, List<Form>> runs = new IdentityHashMap<>();
        plain.body().children().forEach(one -> runs.computeIfAbsent(owners.get(one), owner -> new ArrayList<>()).add(one));
        List<Kept> kept = new ArrayList<>();
        for (Node child : written.children()) {
            kept.addAll(child(child, runs.getOrDefault(child, List.of()), level));
        }
        for (int j = 0; j < level.nows.size(); j++) {
            if (level.origins.get(j) < 0) {
                add(kept, new Kept(node(level.nows.get(j)), j));
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

    private List<Kept> child(Node child, List<Form> run, Level level) {
        int last = -2;
        boolean isSame = true;
        for (Form one : run) {
            Integer place = level.places.get(one);
            int fate = place == null ? -2 : level.fates.get(place);
            isSame &= place == null || (fate >= 0 && level.olds.get(place).equals(level.nows.get(fate)));
            last = fate >= 0 ? fate : last;
        }
        if (isSame) {
            return List.of(new Kept(child, last));
        }
        if (copying != Copying.NONE && child.name().equals(Node.REPEAT)) {
            return followed(child, run, level, last);
        }
        Form first = run.get(0);
        int place = level.places.getOrDefault(first, -1);
        boolean isOne = run.size() == 1 && place >= 0 && level.fates.get(place) >= 0;
        if (isOne && child.equals(stemming.get(first)) && first.body().name().equals(child.name())) {
            return List.of(new Kept(node(child, first, level.olds.get(place), level.nows.get(level.fates.get(place))), last));
        }
        if (isOne && movesInstances && child.name().equals(Node.INSTANCE)) {
            Optional<Node> moved = instance(child, level.olds.get(place), level.nows.get(level.fates.get(place)));
            if (moved.isPresent()) {
                return List.of(new Kept(moved.get(), last));
            }
        }
        List<Kept> written = new ArrayList<>();
        for (Form one : run) {
            Integer at = level.places.get(one);
            if (at != null && level.fates.get(at) >= 0) {
                written.add(new Kept(node(level.nows.get(level.fates.get(at))), level.fates.get(at)));
            }
        }
        return written;
    }

    /** What has become of some elements beside each other: which of the new ones each old one is, and the other way round; -1 for none. */
    private record Level(IdentityHashMap<Form, Integer> places, List<Integer> fates, List<Integer> origins, List<Form> olds, List<Form> nows) {
        Optional<Form> before(Form plain) {
            return Optional.ofNullable(places.get(plain)).map(olds::get);
        }

        Optional<Form> now(Form plain) {
            return Optional.ofNullable(places.get(plain)).filter(place -> fates.get(place) >= 0).map(place -> nows.get(fates.get(place)));
        }
    }

    private static Level level(Form plain, Form before, Form now) {
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
        return new Level(places(plain.body().children(), olds), Arrays.stream(fates).boxed().toList(), Arrays.stream(origins).boxed().toList(), olds, nows);
    }

    /** A repeat with what has become of its first copy, which all others follow; gone if that has gone. */
    private List<Kept> followed(Node repeat, List<Form> run, Level level, int last) {
        isFollowed = true;
        return repeated(repeat, run, level).stream().map(node -> new Kept(node, last)).toList();
    }

    private List<Node> repeated(Node repeat, List<Form> run, Level level) {
        Form first = run.get(0);
        boolean isOne = repeat.equals(stemming.get(first));
        if (!isOne) {
            return around(repeat, repeat.attributes(), originals(repeat, run, level));
        }
        Optional<Form> now = level.now(first);
        if (now.isEmpty()) {
            return List.of();
        }
        Form before = level.before(first).orElseThrow();
        Map<String, String> fresh = now.get().body().attributes();
        Node renamed = repeat;
        for (String own : List.of("name", "material")) {
            String value = fresh.getOrDefault(own, "");
            renamed = value.equals(before.body().attributes().getOrDefault(own, "")) ? renamed : Rewritten.with(renamed, own, Raw.text(value));
        }
        List<Node> inside = around(renamed, renamed.attributes(), originals(repeat, first.body().children(), level(first, before, now.get())));
        Map<String, String> said = before.body().attributes();
        List<Attr> placed = fresh.entrySet().stream()
                .filter(one -> PLACEMENT.contains(one.getKey()) || (OF_WHOLE.contains(one.getKey()) && !one.getValue().equals(said.get(one.getKey())))).map(one -> plain(one.getKey(), one.getValue())).toList();
        // What a repeat says of places is that of its copies to each other: as a whole it stands in something.
        return placed.isEmpty() || inside.isEmpty() ? inside : List.of(new Node("union", placed, inside, "", origin, repeat.at()));
    }

    private List<Node> around(Node repeat, List<Attr> attributes, List<Node> bodies) {
        boolean isEmpty = bodies.stream().allMatch(one -> one.name().equals("material"));
        return isEmpty ? List.of() : List.of(new Node(repeat.name(), attributes, bodies, repeat.content(), origin, repeat.at()));
    }

    private List<Node> originals(Node repeat, List<Form> run, Level level) {
        indices.push(repeat.attribute("index").map(Attr::text).orElse("i"));
        List<Node> fresh = new ArrayList<>();
        for (Node child : repeat.children()) {
            List<Form> own = run.stream().filter(form -> isWithin(child, Objects.requireNonNull(sites.get(form)))).toList();
            if (own.isEmpty()) {
                fresh.add(child);
            } else if (child.name().equals(Node.REPEAT)) {
                fresh.addAll(repeated(child, own, level));
            } else {
                original(child, own.get(0), level).ifPresent(fresh::add);
            }
        }
        indices.pop();
        return fresh;
    }

    private static boolean isWithin(Node node, Node site) {
        return node.equals(site) || node.children().stream().anyMatch(child -> isWithin(child, site));
    }

    private Optional<Node> original(Node child, Form plain, Level level) {
        Optional<Form> now = level.now(plain);
        if (now.isEmpty()) {
            return Optional.empty();
        }
        Form before = level.before(plain).orElseThrow();
        if (before.equals(now.get())) {
            return Optional.of(child);
        }
        Node fresh = child.name().equals(Node.INSTANCE) ? instance(child, before, now.get()).orElseGet(() -> node(now.get())) : node(child, plain, before, now.get());
        // It is the copies that are numbered.
        Optional<String> name = fresh.attribute("name").map(Attr::text).filter(text -> !child.attribute("name").map(Attr::text).equals(Optional.of(text)));
        return Optional.of(name.isEmpty() ? fresh : Rewritten.with(fresh, "name", NUMBERS.matcher(name.get()).replaceAll("")));
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
