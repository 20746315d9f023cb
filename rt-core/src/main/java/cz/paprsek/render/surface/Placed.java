package cz.paprsek.render.surface;

import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.tree.TreeBuilder;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** The objects of a scene as rays meet them, whatever cameras and lights there are. Immutable. */
final class Placed {
    /** Of more transparent solids than this, each may touch others: comparing all their boxes would take long. */
    private static final int MANY_MEDIA = 100;
    /** If more than one of so many objects has changed since all were placed, all are placed anew: two trees are slower to search than one. */
    private static final int SHARE = 16;
    /** Of what lies in one place the lowest part is met first: other things lie on bodies of glass, never a hair's breadth in them. */
    private static final boolean[] MEDIA_LAST = {false, true};

    /** The scene's pictures. */
    final Textures textures;
    final PartTable parts;
    final Bodies bodies;
    /** Of each object whether no light gets through it, and whether it has an inside. */
    final boolean[] opaque;
    final boolean[] solid;
    /** What the inside of each object takes of light: nothing in place of null. */
    final @Nullable Absorption[] absorbing;
    final boolean absorbs;
    /** Whether each object is transparent, has an inside, and may touch another such object. */
    final boolean[] mayTouch;
    /** The first part of every solid without end. */
    final int[] endless;
    /** The placed shape of each object, but for those that have been exchanged. */
    private final Surface[] surfaces;
    /** The objects that have been placed anew, rising, and their shapes. */
    private final int[] exchanged;
    private final Surface[] fresh;
    /** The scene of which all objects were placed, and these. */
    private final Scene scene;
    private final Placed whole;

    /**
     * Places all objects of a scene.
     *
     * @param stop whether to give up, which throws a {@link java.util.concurrent.CancellationException}
     */
    Placed(Scene scene, Textures textures, BooleanSupplier stop) {
        this.textures = textures;
        Placing placing = new Placing(scene, textures, Math.max(16, scene.objects().size()), stop);
        this.scene = scene;
        this.whole = this;
        this.surfaces = new Surface[scene.objects().size()];
        this.opaque = new boolean[surfaces.length];
        this.solid = new boolean[surfaces.length];
        this.absorbing = new Absorption[surfaces.length];
        int[] firsts = new int[surfaces.length];
        for (boolean media : MEDIA_LAST) {
            for (int i = 0; i < surfaces.length; i++) {
                TreeBuilder.stopIfAsked(i, stop);
                SceneObject object = scene.objects().get(i);
                if (placing.isMedium(object) == media) {
                    firsts[i] = placing.size;
                    surfaces[i] = placing.place(i, object, placing.size);
                    opaque[i] = placing.isOpaque(firsts[i]);
                    solid[i] = object.shape() instanceof Solid;
                    absorbing[i] = solid[i] ? placing.absorbing(firsts[i]) : null;
                }
            }
        }
        this.absorbs = Stream.of(absorbing).anyMatch(Objects::nonNull);
        this.parts = new PartTable(placing, firsts);
        this.bodies = Bodies.of(surfaces, opaque, stop);
        this.exchanged = new int[0];
        this.fresh = new Surface[0];
        this.mayTouch = touching();
        this.endless = IntStream.range(0, surfaces.length).filter(this::isEndless).map(parts::firstOf).toArray();
    }

    /** Exchanges some objects, in rising order, which keep the numbers of their parts. */
    private Placed(Placed whole, PartTable parts, int[] exchanged, Surface[] fresh, boolean[] opaque, boolean[] solid,
            @Nullable Absorption[] absorbing, Bodies bodies) {
        this.scene = whole.scene;
        this.textures = whole.textures;
        this.whole = whole;
        this.parts = parts;
        this.surfaces = whole.surfaces;
        this.exchanged = exchanged;
        this.fresh = fresh;
        this.opaque = opaque;
        this.solid = solid;
        this.absorbing = absorbing;
        this.absorbs = whole.absorbs || (absorbing != whole.absorbing && Stream.of(absorbing).anyMatch(Objects::nonNull));
        this.bodies = bodies;
        boolean sameMedia = Arrays.stream(exchanged).noneMatch(object -> isMedium(object) || whole.isMedium(object));
        this.mayTouch = sameMedia ? whole.mayTouch : touching();
        this.endless = IntStream.concat(
                Arrays.stream(whole.endless).filter(part -> Arrays.binarySearch(exchanged, parts.object(part)) < 0),
                Arrays.stream(exchanged).filter(this::isEndless).map(parts::firstOf)).toArray();
    }

    /**
     * The objects of a scene that was made from this one's by a change. Those that are not the very same as when all were placed are placed
     * beside them, unless they are too many; which takes a time that hardly depends on how many there are in all.
     */
    Placed changedTo(Scene changed, BooleanSupplier stop) {
        if (changed.objects().size() != surfaces.length) {
            return new Placed(changed, textures, stop);
        }
        int[] others = others(changed);
        return others.length == 0 ? whole
                : others.length > surfaces.length / SHARE ? new Placed(changed, textures, stop)
                : whole.exchanged(changed, others, stop).orElseGet(() -> new Placed(changed, textures, stop));
    }

    /** The objects that are not the very same, or are made of a named material that is not. */
    private int[] others(Scene changed) {
        Set<String> repainted = new HashSet<>();
        scene.materials().forEach((name, material) -> {
            if (!material.equals(changed.materials().get(name))) {
                repainted.add(name);
            }
        });
        int[] others = changed.objectsOtherThanIn(scene);
        return repainted.isEmpty() ? others : IntStream.concat(Arrays.stream(others), IntStream.range(0, surfaces.length)
                .filter(i -> isMadeOf(repainted, changed.objects().get(i).material(), changed.objects().get(i).shape()))).sorted().distinct().toArray();
    }

    private static boolean isMadeOf(Set<String> names, MaterialSource material, Shape shape) {
        return (material instanceof MaterialName named && names.contains(named.name()))
                || (shape instanceof Csg csg && csg.operands().stream().anyMatch(operand -> isMadeOf(names, operand.material(), operand.solid())));
    }

    /** Empty if the parts of all would get other numbers. */
    private Optional<Placed> exchanged(Scene changed, int[] objects, BooleanSupplier stop) {
        Placing placing = new Placing(changed, textures, objects.length, stop);
        Surface[] theirs = new Surface[objects.length];
        boolean[] theyAreOpaque = new boolean[objects.length];
        boolean[] theyAreSolid = new boolean[objects.length];
        @Nullable Absorption[] theirInside = absorbing;
        for (boolean media : MEDIA_LAST) {
            for (int k = 0; k < objects.length; k++) {
                TreeBuilder.stopIfAsked(k, stop);
                SceneObject object = changed.objects().get(objects[k]);
                if (placing.isMedium(object) != isMedium(objects[k])) {
                    return Optional.empty();
                }
                if (isMedium(objects[k]) == media) {
                    int first = placing.size;
                    theirs[k] = placing.place(objects[k], object, parts.firstOf(objects[k]));
                    theyAreOpaque[k] = placing.isOpaque(first);
                    theyAreSolid[k] = object.shape() instanceof Solid;
                    Absorption inside = theyAreSolid[k] ? placing.absorbing(first) : null;
                    if (inside != null || absorbing[objects[k]] != null) {
                        theirInside = theirInside == absorbing ? absorbing.clone() : theirInside;
                        theirInside[objects[k]] = inside;
                    }
                }
            }
        }
        @Nullable Absorption[] insides = theirInside;
        return parts.with(placing).map(table -> new Placed(this, table, objects, theirs, with(opaque, objects, theyAreOpaque),
                with(solid, objects, theyAreSolid), insides, bodies.with(objects, theirs, theyAreOpaque, stop)));
    }

    /** The very array if nothing is different. */
    private static boolean[] with(boolean[] all, int[] which, boolean[] values) {
        boolean[] changed = all;
        for (int k = 0; k < which.length; k++) {
            if (all[which[k]] != values[k]) {
                changed = changed == all ? all.clone() : changed;
                changed[which[k]] = values[k];
            }
        }
        return changed;
    }

    Surface surface(int object) {
        int at = exchanged.length == 0 ? -1 : Arrays.binarySearch(exchanged, object);
        return at < 0 ? surfaces[object] : fresh[at];
    }

    private boolean isMedium(int object) {
        return !opaque[object] && solid[object];
    }

    private boolean isEndless(int object) {
        return solid[object] && !surface(object).bounds().isFinite();
    }

    private boolean[] touching() {
        boolean[] touching = new boolean[surfaces.length];
        int[] media = IntStream.range(0, surfaces.length).filter(this::isMedium).toArray();
        for (int i : media) {
            touching[i] = media.length > MANY_MEDIA;
        }
        for (int i = 1; i < media.length && media.length <= MANY_MEDIA; i++) {
            for (int j = 0; j < i; j++) {
                if (!surface(media[i]).bounds().padded().intersection(surface(media[j]).bounds().padded()).isEmpty()) {
                    touching[media[i]] = true;
                    touching[media[j]] = true;
                }
            }
        }
        return touching;
    }
}
