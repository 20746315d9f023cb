package cz.paprsek.shape.copied;

import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.copied.Alike.One;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;

/**
 * Which operations of a scene stand in so many places that they are placed once: those that are equal, have {@value #SMALLEST} primitives or more, and
 * {@value #MANY} in all places together, of which those within another one that is placed once count once. It goes by what a scene is, not by how it was
 * made or written: equal scenes make equal pictures. Below that, each place has primitives of its own, which rays meet a little faster.
 */
public final class Repeated {
    /** Solids of fewer primitives are met faster than a ray is taken into their space. */
    static final int SMALLEST = 8;
    /** As operands so many spheres take about 60 MB. */
    static final int MANY = 1 << 16;

    private final Alike alike;
    private final Set<One> once;
    private final long total;
    private final int many;

    private Repeated(Collection<? extends Shape> shapes, int many, Alike alike) {
        this.many = many;
        this.alike = alike;
        this.total = new Sizes().of(shapes);
        this.once = total >= many ? once(shapes) : Set.of();
    }

    /** Looks through the shapes of a scene. */
    public static Repeated in(Collection<? extends Shape> shapes) {
        return in(shapes, MANY);
    }

    /** As the other, of which {@code many} primitives in all places together are enough. */
    static Repeated in(Collection<? extends Shape> shapes, int many) {
        return new Repeated(shapes, many, Alike.remembering());
    }

    /**
     * Whether the same operations are placed once if some of the scene's shapes are taken out and others put in, of which none has such an operation. If too
     * little is known of them to tell, they are not.
     *
     * @param all that there are then; asked only if there are many
     */
    public boolean stays(Collection<? extends Shape> removed, Collection<? extends Shape> added, Supplier<Collection<? extends Shape>> all) {
        if (total < many) {
            return total - new Sizes().of(removed) + new Sizes().of(added) < many;
        }
        Repeated then = new Repeated(all.get(), many, alike.more());
        return then.once.equals(once)
                && reached(added.stream().filter(Csg.class::isInstance).map(csg -> then.alike.of((Csg) csg)).toList()).stream().noneMatch(once::contains);
    }

    /** Whether a solid is to be placed once. */
    boolean has(Csg csg) {
        return !once.isEmpty() && once.contains(alike.of(csg));
    }

    /** Of equal solids always the same one. */
    Csg only(Csg csg) {
        return alike.only(csg);
    }

    private Set<One> once(Collection<? extends Shape> shapes) {
        IdentityHashMap<One, Long> places = new IdentityHashMap<>();
        for (Shape shape : shapes) {
            if (shape instanceof Csg csg) {
                places.merge(alike.of(csg), 1L, Long::sum);
            }
        }
        // What has others inside comes before these.
        List<One> order = reached(places.keySet());
        order.sort(Comparator.comparingInt((One one) -> one.height()).reversed());
        Set<One> found = Collections.newSetFromMap(new IdentityHashMap<>());
        for (One one : order) {
            long times = places.getOrDefault(one, 0L);
            boolean isOnce = one.size() >= SMALLEST && times > 1 && times >= (many + one.size() - 1) / one.size();
            if (isOnce) {
                found.add(one);
            }
            one.within().forEach(inner -> places.merge(inner, isOnce ? 1 : times, Long::sum));
        }
        return found;
    }

    /** These, and all that lie within them. */
    private static List<One> reached(Collection<One> from) {
        List<One> order = new ArrayList<>(from);
        Set<One> known = Collections.newSetFromMap(new IdentityHashMap<>());
        known.addAll(order);
        for (int i = 0; i < order.size(); i++) {
            order.get(i).within().stream().filter(known::add).forEach(order::add);
        }
        return order;
    }

    /** Counts primitives. */
    private static final class Sizes {
        private final IdentityHashMap<Csg, Long> known = new IdentityHashMap<>();

        long of(Collection<? extends Shape> shapes) {
            long sum = 0;
            for (Shape shape : shapes) {
                sum += shape instanceof Csg csg ? of(csg) : 0;
            }
            return sum;
        }

        private long of(Csg csg) {
            Long before = known.get(csg);
            if (before == null) {
                long sum = 0;
                for (Operand operand : csg.operands()) {
                    sum += operand.solid() instanceof Csg inner ? of(inner) : 1;
                }
                before = sum;
                known.put(csg, before);
            }
            return before;
        }
    }
}
