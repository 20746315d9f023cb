package cz.paprsek.shape.copied;

import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** Knows operations for one that are equal but for names and pivots, which nobody sees: each is looked at once, whatever lies within it. */
final class Alike {
    private final Map<Key, One> all = new HashMap<>();
    /** By what has been asked for before. */
    private final IdentityHashMap<Csg, One> seen = new IdentityHashMap<>();
    private final @Nullable Alike base;

    Alike() {
        this(null);
    }

    private Alike(@Nullable Alike base) {
        this.base = base;
    }

    /** Another one that knows all that this one does, and leaves it alone. */
    Alike more() {
        return new Alike(this);
    }

    /** An operation: of equal ones the first that was asked for. */
    static final class One {
        private final Csg csg;
        private final List<One> within;
        private final long size;
        private final int height;

        private One(Csg csg, List<One> within) {
            this.csg = csg;
            this.within = within;
            size = Math.min(Integer.MAX_VALUE, within.stream().mapToLong(one -> one.size).sum() + csg.operands().size() - within.size());
            height = 1 + within.stream().mapToInt(one -> one.height).max().orElse(0);
        }

        Csg csg() {
            return csg;
        }

        /** The operations that are operands of it, as often as they are. */
        List<One> within() {
            return within;
        }

        /** How many primitives it has, or the greatest int if these are more. */
        long size() {
            return size;
        }

        /** How many operations lie within one another. */
        int height() {
            return height;
        }
    }

    /** How many hashes there are among the operations that differ: for tests. */
    int hashes() {
        return (int) all.keySet().stream().mapToInt(Key::hashCode).distinct().count();
    }

    One of(Csg csg) {
        One one = known(csg);
        if (one == null) {
            List<One> within = csg.operands().stream().map(Operand::solid).filter(Csg.class::isInstance).map(inner -> of((Csg) inner)).toList();
            Key key = new Key(csg, within);
            one = known(key);
            if (one == null) {
                one = new One(csg, within);
                all.put(key, one);
            }
            seen.put(csg, one);
        }
        return one;
    }

    private @Nullable One known(Csg csg) {
        One one = seen.get(csg);
        return one == null && base != null ? base.known(csg) : one;
    }

    private @Nullable One known(Key key) {
        One one = all.get(key);
        return one == null && base != null ? base.known(key) : one;
    }

    /** A number that equal operations have in common, and most others do not: of their first and last operands only. */
    static int quick(Csg csg) {
        List<Operand> operands = csg.operands();
        long sum = mixed(mixed(csg.operation().name().hashCode() + 31L * operands.size(), operands.get(0)), operands.get(operands.size() - 1));
        return (int) (sum ^ sum >>> 32);
    }

    /** But for the operations within, and for what nobody sees. */
    private static long mixed(long before, Operand operand) {
        long sum = mixed(before, operand.solid() instanceof Csg ? 1 : operand.solid().hashCode());
        sum = mixed(sum, operand.hidden() ? 1 : 0);
        sum = mixed(sum, operand.material().hashCode());
        Placement placement = operand.placement();
        return mixed(mixed(mixed(sum, placement.position()), placement.rotation()), placement.scale());
    }

    private static long mixed(long sum, Vec3 v) {
        return mixed(mixed(mixed(sum, Double.doubleToLongBits(v.x())), Double.doubleToLongBits(v.y())), Double.doubleToLongBits(v.z()));
    }

    /** All bits count: those of whole numbers differ only in the highest. */
    private static long mixed(long sum, long more) {
        long product = (sum ^ more) * 0x9E3779B97F4A7C15L;
        return product ^ product >>> 29;
    }

    /** What an operation is, but for those within it, which are known by themselves. */
    private static final class Key {
        private final Csg csg;
        private final List<One> within;
        private final int hash;

        Key(Csg csg, List<One> within) {
            this.csg = csg;
            this.within = within;
            long sum = mixed(csg.operation().hashCode(), within.hashCode());
            for (Operand operand : csg.operands()) {
                sum = mixed(sum, operand);
            }
            hash = (int) (sum ^ sum >>> 32);
        }

        @Override
        public int hashCode() {
            return hash;
        }

        @Override
        public boolean equals(Object other) {
            if (!(other instanceof Key key) || hash != key.hash || csg.operation() != key.csg.operation() || !within.equals(key.within)
                    || csg.operands().size() != key.csg.operands().size()) {
                return false;
            }
            for (int i = 0; i < csg.operands().size(); i++) {
                if (!areAlike(csg.operands().get(i), key.csg.operands().get(i))) {
                    return false;
                }
            }
            return true;
        }

        private static boolean areAlike(Operand one, Operand other) {
            boolean areOperations = one.solid() instanceof Csg && other.solid() instanceof Csg;
            return (areOperations || one.solid().equals(other.solid())) && one.placement().equals(other.placement()) && one.hidden() == other.hidden()
                    && one.material().equals(other.material());
        }
    }
}
