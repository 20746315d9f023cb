package cz.paprsek.shape;

import cz.paprsek.attribute.Element;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Carved;
import cz.paprsek.shape.placed.Combination;
import cz.paprsek.shape.placed.Convex;
import cz.paprsek.shape.placed.IntStack;
import cz.paprsek.shape.placed.Nothing;
import cz.paprsek.shape.placed.Operands;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.shape.placed.Volume;
import cz.paprsek.tree.TreeBuilder;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;

/**
 * A solid made of solids by a set operation, nested as deep as scenes take it, 250 levels. Operands stand in the space of the operation.
 *
 * @param operation what is done
 * @param operands at least one; a difference takes all others from the first
 */
@Element("Solids put together: all of them (union), the first without the others (difference), what they have in common (intersection).")
public record Csg(Operation operation, List<Operand> operands) implements Solid {

    /** How two solids make one. */
    public enum Operation implements Combination {
        UNION, DIFFERENCE, INTERSECTION;

        @Override
        public boolean inside(boolean inLeft, boolean inRight) {
            return switch (this) {
                case UNION -> inLeft || inRight;
                case DIFFERENCE -> inLeft && !inRight;
                case INTERSECTION -> inLeft && inRight;
            };
        }

        private Bounds bounds(Bounds left, Bounds right) {
            return switch (this) {
                case UNION -> left.union(right);
                case DIFFERENCE -> left;
                case INTERSECTION -> left.intersection(right);
            };
        }
    }

    public Csg {
        operands = List.copyOf(operands);
        Require.that(!operands.isEmpty(), "a CSG operation needs at least one operand");
    }

    /** All points in any of the solids, as one body without inner walls. */
    public static Csg union(Operand... operands) {
        return new Csg(Operation.UNION, List.of(operands));
    }

    public static Csg union(Solid... solids) {
        return union(operands(solids));
    }

    /** The first solid without the others. */
    public static Csg difference(Operand... operands) {
        return new Csg(Operation.DIFFERENCE, List.of(operands));
    }

    public static Csg difference(Solid... solids) {
        return difference(operands(solids));
    }

    /** The points common to all solids. */
    public static Csg intersection(Operand... operands) {
        return new Csg(Operation.INTERSECTION, List.of(operands));
    }

    public static Csg intersection(Solid... solids) {
        return intersection(operands(solids));
    }

    @Override
    public String kind() {
        return operation.name().toLowerCase(Locale.ROOT);
    }

    @Override
    public Bounds bounds() {
        return bounds(new IdentityHashMap<>());
    }

    /** @param known those of operations that have others within: they may stand in many places */
    private Bounds bounds(Map<Csg, Bounds> known) {
        Bounds all = known.get(this);
        if (all == null) {
            all = operands.stream().filter(operand -> !isGone() && !isGone(operand))
                    .map(operand -> (operand.solid() instanceof Csg csg ? csg.bounds(known) : operand.solid().bounds()).transformed(operand.placement().toParent()))
                    .reduce(operation::bounds)
                    .orElse(Bounds.EMPTY);
            if (operands.stream().anyMatch(operand -> operand.solid() instanceof Csg)) {
                known.put(this, all);
            }
        }
        return all;
    }

    /** Whether nothing is left of it, as all of it is hidden, or what others are taken from. */
    private boolean isGone() {
        return operation == Operation.DIFFERENCE ? isGone(operands.get(0)) : operands.stream().allMatch(Csg::isGone);
    }

    private static boolean isGone(Operand operand) {
        return operand.hidden() || (operand.solid() instanceof Csg csg && csg.isGone());
    }

    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        return List.of();
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return parts.placed(this, this::placeAlone, toWorld);
    }

    private Volume placeAlone(Affine toWorld, Parts parts) {
        Volume[] placed = new Volume[operands.size()];
        boolean isGone = isGone();
        int count = 0;
        for (int i = 0; i < placed.length; i++) {
            TreeBuilder.stopIfAsked(i, parts::isCancelled);
            Operand operand = operands.get(i);
            refuseOpen(operand.solid());
            Affine operandToWorld = toWorld.after(operand.placement().toParent());
            // Parts are counted, also of what is hidden.
            Volume whole = operand.solid().place(operandToWorld, parts.within(operand.material(), operandToWorld));
            if (!isGone && !isGone(operand)) {
                placed[count++] = whole;
            }
        }
        return count == 0 ? Nothing.NOTHING : count == 1 ? placed[0] : new Placed(operation, Arrays.copyOf(placed, count), parts::isCancelled);
    }

    /**
     * Looks whether a solid can be an operand, which a mesh shows only when its triangles are there.
     *
     * @throws IllegalArgumentException if it is a mesh with open edges, saying how many
     */
    public void refuseOpen(Solid solid) {
        Objects.requireNonNull(solid, "solid");
        if (solid instanceof Mesh mesh && !mesh.hasInside()) {
            int open = mesh.triangles().openEdges();
            throw new IllegalArgumentException("the mesh " + (mesh.file().isEmpty() ? "made in code" : '"' + mesh.file() + '"') + " has no inside, so <" + kind()
                    + "> cannot use it: " + (open == 1 ? "1 of its edges is open" : open + " of its edges are open"));
        }
    }

    /** Solids that are one, as placed. */
    static Volume together(List<Volume> solids, Parts parts) {
        return solids.size() == 1 ? solids.get(0) : new Placed(Operation.UNION, solids.toArray(Volume[]::new), parts::isCancelled);
    }

    private static Operand[] operands(Solid[] solids) {
        return Arrays.stream(solids).map(Operand::of).toArray(Operand[]::new);
    }

    /** The operands one after the other, each combined with the result of those before it. */
    private static final class Placed extends Volume {
        /** More operands than this are looked for in a tree. */
        private static final int MANY = 8;

        private final Operation operation;
        private final Volume[] operands;
        private final Bounds[] boxes;
        /** Which operands are met as soon as their boxes are. */
        private final boolean[] quick;
        private final Bounds bounds;
        private final double cost;
        /** Finds the operands that matter, if there are many, and one that is not met does not. */
        private final @Nullable Operands tree;
        /** Meets it at first, if it is such a body. */
        private final @Nullable Carved carved;

        Placed(Operation operation, Volume[] operands, BooleanSupplier stop) {
            this.operation = operation;
            this.operands = operands;
            this.boxes = Arrays.stream(operands).map(operand -> operand.bounds().padded()).toArray(Bounds[]::new);
            this.quick = quick(operands);
            this.bounds = Arrays.stream(operands).map(Surface::bounds).reduce(operation::bounds).orElseThrow();
            this.carved = carved(operation, Arrays.stream(operands).map(Volume::carved).toList()).orElse(null);
            // To meet each operand, and to combine what it pushes, which a carved body mostly does without; and many rays pass by the ball around that.
            double[] costs = Arrays.stream(operands).mapToDouble(operand -> operand.cost() + (carved == null ? 3 : 0.5)).toArray();
            this.cost = Arrays.stream(costs).sum();
            this.tree = operands.length > MANY && operation != Operation.INTERSECTION ? new Operands(boxes, costs, stop) : null;
        }

        private static Optional<Carved> carved(Operation operation, List<Optional<Carved>> operands) {
            return switch (operation) {
                case UNION -> Carved.union(operands);
                case DIFFERENCE -> Carved.difference(operands);
                case INTERSECTION -> Carved.intersection(operands);
            };
        }

        private static boolean[] quick(Volume[] operands) {
            boolean[] quick = new boolean[operands.length];
            for (int i = 0; i < quick.length; i++) {
                quick[i] = operands[i] instanceof Convex && operands[i].cost() <= 1;
            }
            return quick;
        }

        @Override
        public Bounds bounds() {
            return bounds;
        }

        @Override
        public double cost() {
            return cost;
        }

        @Override
        public Optional<Carved> carved() {
            return Optional.ofNullable(carved);
        }

        @Override
        public void nearest(Ray ray) {
            if (carved == null || !carved.nearest(ray)) {
                super.nearest(ray);
            }
        }

        @Override
        public boolean occludes(Ray ray) {
            return carved == null ? super.occludes(ray) : carved.occludes(ray, this);
        }

        @Override
        public void spans(Ray ray, Spans out) {
            if (tree != null) {
                spansOfMany(tree, ray, out);
                return;
            }
            int left = out.size();
            operands[0].spans(ray, out);
            for (int i = 1; i < operands.length; i++) {
                if (operation != Operation.UNION && !out.reaches(left, ray)) {
                    out.release(left);
                    return;
                }
                // Whoever meets an intersection has met the boxes of all its operands.
                if (operation == Operation.INTERSECTION || quick[i] || ray.meets(boxes[i])) {
                    operands[i].combine(operation, left, ray, out);
                }
            }
        }

        /** In the order of the operands all the same: of surfaces in one place, the first one's is seen. */
        private void spansOfMany(Operands among, Ray ray, Spans out) {
            int left = out.size();
            if (operation == Operation.DIFFERENCE) {
                operands[0].spans(ray, out);
                if (!out.reaches(left, ray)) {
                    out.release(left);
                    return;
                }
            }
            IntStack met = ray.met;
            int mark = met.size();
            among.meet(ray, met);
            int end = met.size();
            for (int i = mark; i < end; i++) {
                if (operation == Operation.UNION || met.get(i) > 0) {
                    operands[met.get(i)].combine(operation, left, ray, out);
                }
            }
            met.release(mark);
        }
    }
}
