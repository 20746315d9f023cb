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
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.LongStream;

/**
 * Which operations of a scene stand in so many places that they are placed once: those that are equal but for names and pivots, have {@value #SMALLEST} primitives or more, and
 * {@value #MANY} in all places together, of which those within another one that is placed once count once. It goes by what a scene is, not by how it was
 * made or written: equal scenes make equal pictures. Below that, each place has primitives of its own, which rays meet a little faster.
 */
public final class Repeated {
    /** Solids of fewer primitives are met faster than a ray is taken into their space. */
    static final int SMALLEST = 4;
    /** As operands so many spheres take about 60 MB. */
    static final int MANY = 1 << 16;

    private final int many;
    private final Set<One> once;
    /** Knows those, if there are any. */
    private final Alike alike;
    /** If there are none: so many primitives operations would have to be added for one of them to be placed once. */
    private final long left;

    private Repeated(Collection<? extends Shape> shapes, int many, Alike alike) {
        this.many = many;
        long most = Math.min(primitives(shapes, many), new Crowds().most(shapes));
        IdentityHashMap<One, Long> places = most < many ? new IdentityHashMap<>() : places(shapes, alike);
        this.once = places.isEmpty() ? Set.of() : once(places);
        this.left = once.isEmpty() ? left(places, most < many ? many - most : many) : 0;
        this.alike = once.isEmpty() ? new Alike() : alike;
    }

    /**
     * Looks through the shapes of a scene.
     *
     * @throws IllegalArgumentException if they have more than {@value Original#MOST} primitives
     */
    public static Repeated in(Collection<? extends Shape> shapes) {
        return in(shapes, MANY);
    }

    /** As the other, of which {@code many} primitives in all places together are enough. */
    static Repeated in(Collection<? extends Shape> shapes, int many) {
        return new Repeated(shapes, many, new Alike());
    }

    private Repeated(Repeated same, Alike alike) {
        this.many = same.many;
        this.once = same.once;
        this.left = same.left;
        this.alike = alike;
    }

    /**
     * What is placed once if some of the scene's shapes are taken out and others put in; empty if those are not the same operations any more.
     *
     * @param all that there are then; asked only if what is taken out or put in is much
     */
    public Optional<Repeated> changed(Collection<? extends Shape> removed, Collection<? extends Shape> added, Supplier<Collection<? extends Shape>> all) {
        if (once.isEmpty()) {
            return Optional.of(this).filter(same -> primitives(fresh(removed, added), many) < left || in(all.get(), many).once.isEmpty());
        }
        if (primitives(fresh(removed, added), 1) == 0 && primitives(fresh(added, removed), 1) == 0) {
            return Optional.of(new Repeated(this, alike.more()));
        }
        return Optional.of(new Repeated(all.get(), many, alike.more())).filter(then -> then.once.equals(once));
    }

    /** Whether one of some shapes is placed once, or has something within that is. */
    public boolean areWithin(Collection<? extends Shape> shapes) {
        return !once.isEmpty() && reached(shapes.stream().filter(Csg.class::isInstance).map(csg -> alike.of((Csg) csg)).toList()).stream().anyMatch(once::contains);
    }

    /** Finds how many primitives operations can have, at most, that are equal: told apart by the little that is looked at first. */
    private static final class Crowds {
        private static final int ROOM = 1 << 12;
        /** If there are more to be walked through, all may be equal. */
        private static final long LONGEST_WALK = 1 << 23;

        private final long[] sums = new long[ROOM];
        private long walked;

        long most(Collection<? extends Shape> shapes) {
            for (Shape shape : shapes) {
                if (shape instanceof Csg csg && walked <= LONGEST_WALK) {
                    add(csg);
                }
            }
            return walked > LONGEST_WALK ? Long.MAX_VALUE : LongStream.of(sums).max().orElse(0);
        }

        private long add(Csg csg) {
            long size = 0;
            for (Operand operand : csg.operands()) {
                if (walked <= LONGEST_WALK) {
                    size += operand.solid() instanceof Csg inner ? add(inner) : 1;
                }
            }
            walked += 1 + csg.operands().size();
            if (size >= SMALLEST) {
                sums[Alike.quick(csg) & ROOM - 1] += size;
            }
            return size;
        }
    }

    /** Those added that are not the same as one removed, as those of what has only been moved are. */
    private static List<Shape> fresh(Collection<? extends Shape> removed, Collection<? extends Shape> added) {
        IdentityHashMap<Shape, Integer> gone = new IdentityHashMap<>();
        removed.forEach(shape -> gone.merge(shape, 1, Integer::sum));
        return added.stream().<Shape>map(shape -> shape).filter(shape -> gone.merge(shape, -1, Integer::sum) < 0).toList();
    }

    /** How many primitives operations have that are not too small, or some number that is not below {@code most}: so it soon is told of whatever nest. */
    private static long primitives(Collection<? extends Shape> shapes, long most) {
        long sum = 0;
        for (Shape shape : shapes) {
            if (shape instanceof Csg csg && sum < most) {
                long own = primitives(csg, Math.max(SMALLEST, most - sum));
                sum += own < SMALLEST ? 0 : own;
            }
        }
        return sum;
    }

    /** How many primitives an operation has, or some number that is not below {@code most}. */
    public static long primitives(Csg csg, long most) {
        long sum = 0;
        for (Operand operand : csg.operands()) {
            if (sum >= most) {
                break;
            }
            sum += operand.solid() instanceof Csg inner ? primitives(inner, most - sum) : 1;
        }
        return sum;
    }

    /** Whether a solid is to be placed once. */
    boolean has(Csg csg) {
        return !once.isEmpty() && once.contains(alike.of(csg));
    }

    /** Of equal solids always the same one. */
    Csg only(Csg csg) {
        return alike.of(csg).csg();
    }

    /** How often each operation stands in a scene by itself. */
    private static IdentityHashMap<One, Long> places(Collection<? extends Shape> shapes, Alike alike) {
        IdentityHashMap<One, Long> places = new IdentityHashMap<>();
        int total = 0;
        for (Shape shape : shapes) {
            if (shape instanceof Csg csg) {
                One one = alike.of(csg);
                places.merge(one, 1L, Long::sum);
                total = Original.sum(total, one.size());
            }
        }
        return places;
    }

    /** @param places to which those within others are added */
    private Set<One> once(IdentityHashMap<One, Long> places) {
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

    /** @param most what it is at most */
    private long left(IdentityHashMap<One, Long> places, long most) {
        long least = most;
        for (Map.Entry<One, Long> entry : places.entrySet()) {
            long size = entry.getKey().size();
            if (size >= SMALLEST) {
                least = Math.min(least, Math.max(size, many - entry.getValue() * size));
            }
        }
        return least;
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
}
