package cz.paprsek.xml.quick;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Bump;
import cz.paprsek.material.Material.NormalMap;
import cz.paprsek.material.Material.Relief;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share;
import cz.paprsek.material.Share.Even;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/** Reads {@code <material>}, which stands in a scene with a name, and without one in an object. */
final class MaterialReader {
    static final byte[] ELEMENT = Slot.ascii("material");

    private static final int KNOWN = 256;

    private static final RecordForm<Material> MATERIAL = new RecordForm<>(Material.class);
    private static final List<Slot> OWN = List.of(Slot.optional("name", ValueForm.TEXT, Slot.NONE), Slot.optional("color", ValueForm.COLOR, Slot.NONE));
    private static final TagForm TAG = new TagForm(OWN, MATERIAL.slots());

    /** The shares that may have a pattern, and which of the material's attributes they are. */
    private static final List<Name> SHARES = shares(Name::new);
    private static final List<Integer> PLACES = shares(Described.of(Material.class).stream().map(Described::name).toList()::indexOf);
    private static final RecordForm<Material.Shares> SHARES_FORM = new RecordForm<>(Material.Shares.class);
    private static final Object[] NOTHING = {};
    private static final Object[] EVEN = Collections.nCopies(SHARES.size(), new Even()).toArray();
    private static final RecordForm<Share.ByPattern> BY_PATTERN = new RecordForm<>(Share.ByPattern.class);
    private static final TagForm BY_PATTERN_TAG = new TagForm(BY_PATTERN.slots(), List.of());
    private static final Name BUMP = new Name(ElementTable.name(Bump.class));
    private static final RecordForm<Bump> BUMPS = new RecordForm<>(Bump.class);
    private static final TagForm BUMP_TAG = new TagForm(BUMPS.slots(), List.of());
    private static final Name NORMAL_MAP = new Name(ElementTable.name(NormalMap.class));
    private static final RecordForm<NormalMap> NORMAL_MAPS = new RecordForm<>(NormalMap.class);
    private static final RecordForm<Pattern.Lay> LAY = new RecordForm<>(Pattern.Lay.class);
    private static final TagForm NORMAL_MAP_TAG = new TagForm(NORMAL_MAPS.slots(), LAY.slots());

    private final Markup markup;
    private final double[] room;
    /** Some that were read, found by their tags: as they are written, in how many elements they were, and what they are. */
    private final byte[][] texts;
    private final int[] depths;
    private final Named[] known;

    /** @param room for three numbers */
    MaterialReader(Markup markup, double[] room) {
        this(markup, room, new byte[KNOWN][0], new int[KNOWN], new Named[KNOWN]);
    }

    private MaterialReader(Markup markup, double[] room, byte[][] texts, int[] depths, Named[] known) {
        this.markup = markup;
        this.room = room;
        this.texts = texts;
        this.depths = depths;
        this.known = known;
    }

    /** One that knows those that this one knows, and reads others from elsewhere. */
    MaterialReader knowing(Markup elsewhere, double[] other) {
        return new MaterialReader(elsewhere, other, texts.clone(), depths.clone(), known.clone());
    }

    private static <T> List<T> shares(Function<String, T> each) {
        return Arrays.stream(Material.Shares.class.getRecordComponents()).map(Described::name).map(each).toList();
    }

    /** A material with its name, which is empty if it has none. */
    record Named(String name, Material material) {}

    /** The material whose start tag is at hand: one that is known, if it is written as that was, as often where there are many bodies. */
    Named read(int depth) throws IOException {
        int i = markup.fingerprint() & KNOWN - 1;
        if (depth > depths[i] || !markup.isOnceMore(texts[i])) {
            long place = markup.place();
            known[i] = another(depth);
            depths[i] = depth;
            texts[i] = markup.since(place);
        }
        return known[i];
    }

    private Named another(int depth) throws IOException {
        Object[] values = TAG.read(markup, room);
        Pattern pattern = null;
        Object[] shares = EVEN;
        Relief relief = Relief.FLAT;
        if (markup.hasContent(depth)) {
            while (markup.nextTag()) {
                int share = share();
                if (share >= 0) {
                    shares = shares == EVEN ? EVEN.clone() : shares;
                    Unusual.unless(shares[share] instanceof Even && MATERIAL.isUntouched(values, OWN.size(), PLACES.get(share)));
                    shares[share] = around(SHARES.get(share), BY_PATTERN, BY_PATTERN_TAG, depth + 1);
                } else if (BUMP.isAtHand(markup) || NORMAL_MAP.isAtHand(markup)) {
                    Unusual.unless(relief == Relief.FLAT);
                    relief = BUMP.isAtHand(markup) ? around(BUMP, BUMPS, BUMP_TAG, depth + 1) : normalMap(depth + 1);
                } else {
                    Unusual.unless(pattern == null);
                    pattern = pattern(depth + 1);
                }
            }
            markup.endTag(ELEMENT);
        }
        return new Named((String) values[0], MATERIAL.make(values, OWN.size(), pattern(values[1], pattern), shares == EVEN ? Material.Shares.EVEN : SHARES_FORM.make(NOTHING, 0, shares), relief));
    }

    private static Pattern pattern(Object color, @Nullable Pattern inside) {
        Unusual.unless(inside == null || color == Slot.NONE);
        return inside != null ? inside : color instanceof Rgb plain ? new Pattern.Plain(plain) : Material.DEFAULT.pattern();
    }

    /** Which of the shares the element at hand is; −1 if it is none. */
    private int share() {
        for (int i = 0; i < SHARES.size(); i++) {
            if (SHARES.get(i).isAtHand(markup)) {
                return i;
            }
        }
        return -1;
    }

    /** An element with one pattern inside. */
    private <R extends Record> R around(Name name, RecordForm<R> form, TagForm tag, int depth) throws IOException {
        Object[] values = tag.read(markup, room);
        Unusual.unless(markup.hasContent(depth) && markup.nextTag());
        Pattern inside = pattern(depth + 1);
        Unusual.unless(!markup.nextTag());
        name.end(markup);
        return form.make(values, 0, inside);
    }

    private Relief normalMap(int depth) throws IOException {
        Object[] values = NORMAL_MAP_TAG.read(markup, room);
        if (markup.hasContent(depth)) {
            Unusual.unless(!markup.nextTag());
            NORMAL_MAP.end(markup);
        }
        return NORMAL_MAPS.make(values, 0, LAY.make(values, NORMAL_MAPS.slots().size()));
    }

    private Pattern pattern(int depth) throws IOException {
        for (PatternForm form : PatternForm.ALL) {
            if (form.name().isAtHand(markup)) {
                Object[] values = form.tag().read(markup, room);
                return form.make(values, stops(form, depth));
            }
        }
        throw new Unusual();
    }

    private List<Pattern.Stop> stops(PatternForm form, int depth) throws IOException {
        List<Pattern.Stop> stops = new ArrayList<>();
        if (markup.hasContent(depth)) {
            while (markup.nextTag()) {
                Unusual.unless(markup.isNamed(PatternForm.STOP) && stops.size() < Pattern.Stops.MOST);
                Object[] values = PatternForm.STOP_TAG.read(markup, room);
                markup.noContent(PatternForm.STOP, depth + 1);
                stops.add(PatternForm.STOPS.make(values, 0));
            }
            form.name().end(markup);
        }
        return stops;
    }
}
