package cz.paprsek.shape.field;

import cz.paprsek.formula.Formula;
import cz.paprsek.formula.FormulaException;
import cz.paprsek.formula.Function;
import cz.paprsek.formula.Term;
import cz.paprsek.ray.Line;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * A formula of x, y and z as a list of steps, each of which takes what earlier ones came to: its value at a point, and within which bounds it and its
 * slope stay along a stretch of a line. What stands there twice is worked out once. Immutable; whoever asks brings room.
 */
public final class Field {
    private static final List<String> COORDINATES = List.of("x", "y", "z");
    private static final Function[] FUNCTIONS = Function.values();

    /** The numbers in it; they come after x, y and z. */
    private final double[] constants;
    /** Of each step its function and the places of what it takes. */
    private final int[] steps;

    /**
     * @throws IllegalArgumentException with one sentence that begins with {@code what} if the text is no formula of x, y and z
     */
    public Field(String what, String text) {
        Formula formula;
        try {
            formula = Formula.of(text);
        } catch (FormulaException e) {
            throw new IllegalArgumentException(what + " must be a formula, but at character " + e.column() + ": " + e.getMessage(), e);
        }
        for (String name : formula.names()) {
            if (!COORDINATES.contains(name)) {
                throw new IllegalArgumentException(what + " must be a formula of x, y and z, but has \"" + name + "\"");
            }
        }
        Compiler compiler = new Compiler();
        int last = compiler.place(formula.term());
        // The last step is the outcome: x alone is one, too.
        compiler.step(Function.PLUS, last, compiler.constant(0), 0);
        constants = compiler.constants.stream().mapToDouble(Double::doubleValue).toArray();
        steps = compiler.finished();
    }

    /** Places are numbered from 0 in each of three: coordinates, constants, and steps, in this order. */
    private static final class Compiler {
        private static final int CONSTANT = 1 << 20;
        private static final int STEP = 1 << 21;

        final List<Double> constants = new ArrayList<>();
        private final List<int[]> steps = new ArrayList<>();
        private final Map<List<Integer>, Integer> known = new HashMap<>();

        int place(Term term) {
            if (term instanceof Term.Constant constant) {
                return constant(constant.value());
            } else if (term instanceof Term.Name name) {
                return COORDINATES.indexOf(name.name());
            }
            Term.Call call = (Term.Call) term;
            int[] of = call.terms().stream().mapToInt(this::place).toArray();
            if (call.function() == Function.CLAMP) {
                return step(Function.MAX, of[1], step(Function.MIN, of[2], of[0], 0), 0);
            } else if (call.function() == Function.MIX) {
                return step(Function.PLUS, of[0], step(Function.TIMES, step(Function.MINUS, of[1], of[0], 0), of[2], 0), 0);
            }
            return step(call.function(), of[0], of.length > 1 ? of[1] : 0, of.length > 2 ? of[2] : 0);
        }

        int constant(double value) {
            int at = constants.indexOf(value);
            if (at < 0) {
                at = constants.size();
                constants.add(value);
            }
            return CONSTANT + at;
        }

        int step(Function function, int a, int b, int c) {
            int number = Arrays.asList(FUNCTIONS).indexOf(function);
            return known.computeIfAbsent(List.of(number, a, b, c), unknown -> {
                steps.add(new int[] {number, a, b, c});
                return STEP + steps.size() - 1;
            });
        }

        int[] finished() {
            return steps.stream().flatMapToInt(step -> Arrays.stream(new int[] {step[0], at(step[1]), at(step[2]), at(step[3])})).toArray();
        }

        private int at(int place) {
            return place >= STEP ? 3 + constants.size() + place - STEP : place >= CONSTANT ? 3 + place - CONSTANT : place;
        }
    }

    /** How many numbers of room it takes. */
    int room() {
        return Enclosed.SIZE * (3 + constants.length + steps.length / 4);
    }

    /** What it comes to at a point; what is no number there counts as being outside. */
    public double value(double x, double y, double z, double[] room) {
        room[0] = x;
        room[1] = y;
        room[2] = z;
        System.arraycopy(constants, 0, room, 3, constants.length);
        int out = 3 + constants.length;
        for (int i = 0; i < steps.length; i += 4) {
            room[out++] = of(FUNCTIONS[steps[i]], room[steps[i + 1]], room[steps[i + 2]], room[steps[i + 3]]);
        }
        double value = room[out - 1];
        return Double.isNaN(value) ? 1 : value;
    }

    /** The common ones first: a call of a constant's own method is slow where there are many. */
    private static double of(Function function, double a, double b, double c) {
        return switch (function) {
            case PLUS -> a + b;
            case MINUS -> a - b;
            case TIMES -> a * b;
            case NEGATE -> -a;
            case POWER -> b == 2 ? a * a : b == 3 ? a * a * a : function.of(a, b, c);
            default -> function.of(a, b, c);
        };
    }

    /** Room for one who asks seldom. */
    public double[] newRoom() {
        return new double[room()];
    }

    /**
     * Bounds of its values and slopes for all t of a stretch of a line.
     *
     * @param room where they are found afterwards, from the place that is returned on: least and largest value, least and largest slope
     */
    int along(Line line, double from, double to, double[] room) {
        coordinate(room, 0, line.ox, line.dx, from, to);
        coordinate(room, Enclosed.SIZE, line.oy, line.dy, from, to);
        coordinate(room, 2 * Enclosed.SIZE, line.oz, line.dz, from, to);
        return work(room);
    }

    /** The same for a box, with the slopes along one axis. */
    public int within(double[] box, int axis, double[] room) {
        for (int i = 0; i < 3; i++) {
            Enclosed.set(room, i * Enclosed.SIZE, box[i], box[3 + i], i == axis ? 1 : 0, i == axis ? 1 : 0);
        }
        return work(room);
    }

    /** The same at a point. */
    int at(double x, double y, double z, int axis, double[] room) {
        Enclosed.set(room, 0, x, x, axis == 0 ? 1 : 0, axis == 0 ? 1 : 0);
        Enclosed.set(room, Enclosed.SIZE, y, y, axis == 1 ? 1 : 0, axis == 1 ? 1 : 0);
        Enclosed.set(room, 2 * Enclosed.SIZE, z, z, axis == 2 ? 1 : 0, axis == 2 ? 1 : 0);
        return work(room);
    }

    private int work(double[] room) {
        for (int i = 0; i < constants.length; i++) {
            Enclosed.set(room, (3 + i) * Enclosed.SIZE, constants[i], constants[i], 0, 0);
        }
        int out = (3 + constants.length) * Enclosed.SIZE;
        for (int i = 0; i < steps.length; i += 4) {
            Enclosed.apply(FUNCTIONS[steps[i]], room, steps[i + 1] * Enclosed.SIZE, steps[i + 2] * Enclosed.SIZE, steps[i + 3] * Enclosed.SIZE, out);
            out += Enclosed.SIZE;
        }
        return out - Enclosed.SIZE;
    }

    private static void coordinate(double[] room, int at, double o, double d, double from, double to) {
        double one = o + from * d;
        double other = o + to * d;
        double slack = 4e-16 * (Math.abs(o) + Math.max(Math.abs(from), Math.abs(to)) * Math.abs(d));
        Enclosed.set(room, at, Math.min(one, other) - slack, Math.max(one, other) + slack, d, d);
    }
}
