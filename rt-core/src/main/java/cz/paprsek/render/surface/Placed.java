package cz.paprsek.render.surface;

import cz.paprsek.list.Difference;
import cz.paprsek.list.Pieces;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.copied.Originals;
import cz.paprsek.shape.copied.Repeated;
import cz.paprsek.shape.placed.Surface;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.IntFunction;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * The objects of a scene as rays meet them, whatever cameras and lights there are. Immutable. Each has a number, which is its index in the scene of which all
 * were placed; those that a change has brought have the next numbers, in the order of the scene, and stand beside the others.
 */
final class Placed {
    /** Of more transparent solids than this, each may touch others: comparing all their boxes would take long. */
    private static final int MANY_MEDIA = 100;
    /** If more than one of so many objects has changed since all were placed, all are placed anew: two trees are slower to search than one. */
    private static final int SHARE = 16;
    /** So many places are left before the first part, and between what is opaque and the parts of glass, for what is placed later. */
    private static final int ROOM = 64;

    /** The scene's pictures. */
    final Textures textures;
    final PartTable parts;
    final Bodies bodies;
    final boolean absorbs;
    /** The first part of every solid without end. */
    final int[] endless;
    private final PlacedObjects first;
    private final PlacedObjects later;
    /** The solids that light gets through, and of these those that may touch others of them. */
    private final int[] media;
    private final BitSet touching;
    private final Difference difference;
    /** The scene of which all objects were placed, and these. */
    private final Scene scene;
    private final Placed whole;
    /** The solids in it that were placed once. */
    private final Repeated repeated;
    private final Originals originals;

    /**
     * Places all objects of a scene.
     *
     * @param stop whether to give up, which throws a {@link java.util.concurrent.CancellationException}
     */
    Placed(Scene scene, Textures textures, BooleanSupplier stop) {
        int count = scene.objects().size();
        this.repeated = Repeated.in(shapes(scene));
        Placing placing = new Placing(scene, textures, Math.max(16, count + 2 * ROOM), repeated, stop);
        this.originals = placing.originals;
        this.textures = textures;
        this.scene = scene;
        this.whole = this;
        this.difference = Difference.NONE;
        this.first = new PlacedObjects(0, count);
        this.later = new PlacedObjects(count, 0);
        placing.leaveRoom(ROOM);
        boolean[] hadMedium = {false};
        first.place(placing, scene.objects()::get, (object, isMedium) -> {
            placing.leaveRoom(isMedium && !hadMedium[0] ? ROOM : 0);
            hadMedium[0] = isMedium;
            return PartTable.number(placing.places);
        }, stop);
        this.parts = new PartTable(placing, first.firsts);
        this.bodies = Bodies.of(first.surfaces, first.opaque, stop);
        this.absorbs = first.absorb;
        this.media = IntStream.range(0, count).filter(this::isMedium).toArray();
        this.touching = touching();
        this.endless = IntStream.range(0, count).filter(this::isEndless).map(parts::firstOf).toArray();
    }

    /** Takes some objects out of those that were placed all at once, and puts others beside them. */
    private Placed(Placed whole, Difference difference, PartTable parts, PlacedObjects later, Bodies bodies) {
        this.textures = whole.textures;
        this.scene = whole.scene;
        this.repeated = whole.repeated;
        this.originals = whole.originals;
        this.whole = whole;
        this.difference = difference;
        this.first = whole.first;
        this.later = later;
        this.parts = parts;
        this.bodies = bodies;
        this.absorbs = whole.absorbs || later.absorb;
        int[] fresh = IntStream.range(later.from, later.from + later.surfaces.length).toArray();
        boolean sameMedia = Arrays.stream(difference.removed()).noneMatch(first::isMedium) && Arrays.stream(fresh).noneMatch(this::isMedium);
        this.media = sameMedia ? whole.media
                : IntStream.concat(Arrays.stream(whole.media).filter(difference::keeps), Arrays.stream(fresh).filter(this::isMedium)).toArray();
        this.touching = sameMedia ? whole.touching : touching();
        this.endless = IntStream.concat(Arrays.stream(whole.endless).filter(part -> difference.keeps(parts.object(part))),
                Arrays.stream(fresh).filter(this::isEndless).map(parts::firstOf)).toArray();
    }

    /**
     * The objects of a scene that was made from this one's by a change. Those that are not the very same as when all were placed are placed
     * beside them, unless they are too many; which takes a time that hardly depends on how many there are in all.
     */
    Placed changedTo(Scene changed, BooleanSupplier stop) {
        int most = first.surfaces.length / SHARE;
        Difference fromWhole = Difference.of(Pieces.of(scene.objects()), Pieces.of(changed.objects()), repainted(changed), most);
        if (fromWhole.isNone()) {
            return whole;
        }
        return (Math.max(fromWhole.removed().length, fromWhole.added().length) > most ? Optional.<Repeated>empty() : stays(changed, fromWhole))
                .flatMap(then -> whole.with(changed, fromWhole, then, stop)).orElseGet(() -> new Placed(changed, textures, stop));
    }

    /** What is placed once after a change, if that is the same; empty, too, if such a thing would be of other materials. */
    private Optional<Repeated> stays(Scene changed, Difference fromWhole) {
        List<Shape> added = shapes(changed, fromWhole.added());
        return repeated.changed(shapes(scene, fromWhole.removed()), added, () -> shapes(changed))
                .filter(then -> scene.materials().equals(changed.materials()) || !then.areWithin(added));
    }

    private static List<Shape> shapes(Scene of) {
        return of.objects().stream().map(SceneObject::shape).toList();
    }

    private static List<Shape> shapes(Scene of, int[] objects) {
        return Arrays.stream(objects).mapToObj(i -> of.objects().get(i).shape()).toList();
    }

    /** Says which objects are made of a named material that is not the same; it may have been one that every scene knows, or be one now. */
    private Predicate<? super SceneObject> repainted(Scene changed) {
        Set<String> names = Stream.concat(scene.materials().keySet().stream(), changed.materials().keySet().stream().filter(Material.ready()::containsKey))
                .filter(name -> !new MaterialName(name).in(scene.materials()).equals(new MaterialName(name).in(changed.materials()))).collect(Collectors.toSet());
        return names.isEmpty() ? Pieces.NONE : object -> isMadeOf(names, object.material(), object.shape(), object.shape() instanceof Csg ? Collections.newSetFromMap(new IdentityHashMap<>()) : Set.of());
    }

    private static boolean isMadeOf(Set<String> names, MaterialSource material, Shape shape, Set<Csg> seen) {
        return (material instanceof MaterialName named && names.contains(named.name()))
                || (shape instanceof Csg csg && seen.add(csg) && csg.operands().stream().anyMatch(operand -> isMadeOf(names, operand.material(), operand.solid(), seen)));
    }

    /** Empty if there is no room for the numbers of the parts that come between others. */
    private Optional<Placed> with(Scene changed, Difference fromWhole, Repeated then, BooleanSupplier stop) {
        int count = fromWhole.added().length;
        Placing placing = Placing.later(changed, textures, Math.max(16, count), originals.in(then), stop);
        IntFunction<SceneObject> objects = k -> changed.objects().get(fromWhole.added()[k]);
        boolean[] areMedia = new boolean[count];
        for (int k = 0; k < count; k++) {
            areMedia[k] = placing.isMedium(objects.apply(k));
        }
        int[] low = new int[count];
        int[] high = new int[count];
        for (boolean medium : PlacedObjects.MEDIA_LAST) {
            neighbours(fromWhole, areMedia, medium, low, high);
        }
        PlacedObjects fresh = new PlacedObjects(first.surfaces.length, count);
        placing.keepBelow(high, fresh.from);
        fresh.place(placing, objects, (k, isMedium) -> PartTable.after(Math.max(low[k], placing.last)), stop);
        return placing.isInRoom ? Optional.of(new Placed(this, fromWhole, parts.with(placing, fresh.firsts), fresh, bodies.with(fromWhole.removed(), fresh.surfaces, fresh.opaque, stop)))
                : Optional.empty();
    }

    /**
     * Between which parts, of objects that are left, those of new ones belong: as they would if all were placed anew, what is opaque before what is glass.
     *
     * @param medium which of the new ones are meant
     */
    private void neighbours(Difference fromWhole, boolean[] areMedia, boolean medium, int[] low, int[] high) {
        int[] places = fromWhole.places();
        int firstMedium = media.length == 0 ? Integer.MAX_VALUE : parts.firstOf(media[0]);
        int lowest = !medium ? 0 : (media.length == 0 ? parts.end() : firstMedium - PartTable.number(ROOM)) - PartTable.number(1);
        int seen = 0;
        for (int k = 0; k < places.length; k++) {
            if (areMedia[k] == medium) {
                int i = places[k] - 1;
                while (i >= seen && !(first.isMedium(i) == medium && fromWhole.keeps(i))) {
                    i--;
                }
                lowest = i < seen ? lowest : parts.lastOf(i);
                low[k] = lowest;
                seen = places[k];
            }
        }
        int highest = medium ? Integer.MAX_VALUE : firstMedium;
        seen = first.surfaces.length;
        for (int k = places.length - 1; k >= 0; k--) {
            if (areMedia[k] == medium) {
                int i = places[k];
                while (i < seen && !(first.isMedium(i) == medium && fromWhole.keeps(i))) {
                    i++;
                }
                highest = i < seen ? parts.firstOf(i) : highest;
                high[k] = highest;
                seen = places[k];
            }
        }
    }

    /** The index in the scene of an object. */
    int index(int object) {
        return object < later.from ? difference.moved(object) : difference.added()[object - later.from];
    }

    /** The indexes in the scene of the objects that a change has brought since all were placed. */
    IntStream later() {
        return Arrays.stream(difference.added());
    }

    Surface surface(int object) {
        return object < later.from ? first.surfaces[object] : later.surfaces[object - later.from];
    }

    /** Whether no light gets through any of an object. */
    boolean isOpaque(int object) {
        return object < later.from ? first.opaque[object] : later.opaque[object - later.from];
    }

    /** Whether an object has an inside. */
    boolean isSolid(int object) {
        return object < later.from ? first.solid[object] : later.solid[object - later.from];
    }

    @Nullable Absorption absorption(int object) {
        return object < later.from ? first.absorbing[object] : later.absorbing[object - later.from];
    }

    /** Whether an object is a solid that light gets through. */
    boolean isMedium(int object) {
        return !isOpaque(object) && isSolid(object);
    }

    /** Whether a solid that light gets through may touch another one. */
    boolean mayTouch(int medium) {
        return media.length > MANY_MEDIA || touching.get(medium);
    }

    private boolean isEndless(int object) {
        return isSolid(object) && !surface(object).bounds().isFinite();
    }

    private BitSet touching() {
        BitSet found = new BitSet();
        for (int i = 1; i < media.length && media.length <= MANY_MEDIA; i++) {
            for (int j = 0; j < i; j++) {
                if (!surface(media[i]).bounds().padded().intersection(surface(media[j]).bounds().padded()).isEmpty()) {
                    found.set(media[i]);
                    found.set(media[j]);
                }
            }
        }
        return found;
    }
}
