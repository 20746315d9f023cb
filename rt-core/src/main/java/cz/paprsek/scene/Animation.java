package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.motion.Quaternion;
import cz.paprsek.shape.outline.Way;
import cz.paprsek.text.Numbers;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.StringTokenizer;
import java.util.function.DoubleFunction;
import java.util.stream.Collectors;

/**
 * What a number, vector or colour of a scene is at which time. Before the first key it is what the first says, behind the last what the last says.
 *
 * @param target what has it: a {@link ScenePath} as text, or {@code param:} and the name of a parameter
 * @param attribute its name in files; {@code value} of a parameter
 * @param turn how three angles come from one key to the next
 * @param path a curve that it goes along, as path data of SVG, seen from above: its x is x, its y is z. Keys then say how far, as a share of its length, and may say how high: of a rotation and a
 *     direction, which lead where the curve does, only how far. Empty for none
 * @param keys at least one, in the order of their times
 */
@Element(name = "animate", value = "What a number, vector or colour is at which time; in between by the ease of the key before, outside of the keys as at the nearest.")
public record Animation(
        @Attribute(value = Kind.LETTERS, means = "What has it: the name of a body, a/b#2 for an operand, camera:name, light:name, material:name, param:name; #2 for the second where there is no name")
        String target,
        @Attribute(value = Kind.NAME, means = "Which attribute of that; value of a parameter") String attribute,
        @Attribute(value = Kind.WORD, means = "How a rotation comes from key to key: each angle by itself, or by the shortest turn", otherwise = "angles") Turning turn,
        @Attribute(value = Kind.PATH, means = "A curve it goes along, as path data of SVG seen from above, x and z; keys then say how far, 0 to 1, and how high", otherwise = Attribute.NOTHING) String path,
        List<Key> keys) {
    /** What targets begin with that are parameters. */
    public static final String PARAMETER = "param:";
    private static final int ANGLES = 3;

    /** How values come from a key to the next, u being how much of the time between them has passed, 0 to 1. */
    public enum Ease {
        /** Evenly: by u. */
        LINEAR,
        /** Slowly at both ends: by 3u² − 2u³. */
        SMOOTH,
        /**
         * Along a curve through all keys, which at each has the slope between the key before and the one behind it; at the ends that to the neighbour.
         *
         * @source Catmull and Rom, A Class of Local Interpolating Splines, 1974, as cubic Hermite curves over keys that need not be evenly spaced
         */
        CATMULL_ROM,
        /** Not at all until the next key. */
        HOLD
    }

    /** What is between two rotations. */
    public enum Turning {
        /** Each of the three angles goes from one to the other. */
        ANGLES,
        /** About one axis, by at most half a turn. */
        SHORTEST
    }

    /**
     * A value at a time.
     *
     * @param t seconds
     * @param value one to three numbers, as files have them: of colours sRGB, of rotations degrees
     * @param ease how it goes on from here
     */
    @Element("A value at a time.")
    public record Key(
            @Attribute(value = Kind.NUMBER, means = "Seconds; the first picture is at 0") double t,
            @Attribute(value = Kind.VALUES, means = "What the attribute is then") String value,
            @Attribute(value = Kind.WORD, means = "How it goes on to the next key", otherwise = "linear") Ease ease) {
        /** @throws IllegalArgumentException if the value is not one to three finite numbers */
        public Key {
            Require.finite("t", t);
            Objects.requireNonNull(value, "value");
            Objects.requireNonNull(ease, "ease");
            value = Arrays.stream(numbers(value)).mapToObj(Numbers::text).collect(Collectors.joining(" "));
        }

        private static double[] numbers(String value) {
            try {
                StringTokenizer words = new StringTokenizer(value);
                double[] numbers = new double[words.countTokens()];
                for (int i = 0; i < numbers.length; i++) {
                    numbers[i] = Require.finite("value", Double.parseDouble(words.nextToken()) + 0.0);
                }
                Require.that(numbers.length >= 1 && numbers.length <= ANGLES, refusal(value));
                return numbers;
            } catch (NumberFormatException none) {
                throw new IllegalArgumentException(refusal(value), none);
            }
        }

        private static String refusal(String value) {
            return "value must be " + Kind.VALUES.words() + ", but is \"" + value + "\"";
        }

        double[] numbers() {
            return numbers(value);
        }
    }

    /** @throws IllegalArgumentException if there is no key, one does not come after the one before, or one has more or fewer numbers than another */
    public Animation {
        Objects.requireNonNull(target, "target");
        Objects.requireNonNull(keys, "keys");
        Require.that(!target.isBlank(), "the target of an animation must not be blank");
        SceneRules.checkName("attribute", attribute);
        Objects.requireNonNull(turn, "turn");
        Objects.requireNonNull(path, "path");
        keys = List.copyOf(keys);
        Require.that(!keys.isEmpty(), "an animation needs a key inside, such as <key t=\"0\" value=\"0 1 0\"/>");
        for (int i = 1; i < keys.size(); i++) {
            checkNext(keys.get(i - 1), keys.get(i));
        }
        Require.that(turn == Turning.ANGLES || keys.get(0).numbers().length == ANGLES, "turn is for rotations, which have three numbers");
        Require.that(turn == Turning.ANGLES || keys.stream().noneMatch(key -> key.ease() == Ease.CATMULL_ROM),
                "the shortest turn goes from key to key linear, smooth or hold, not catmull-rom");
        if (!path.isBlank()) {
            Way.of("animate", path);
            Require.that(!target.startsWith(PARAMETER), "a parameter goes along no path; animate what is made of it");
            int count = keys.get(0).numbers().length;
            Require.that(count <= 2, "along a path, value must be one number, the share of its length, or two, that and the height, but has " + count);
        }
    }

    /** What does not go along a path. */
    public Animation(String target, String attribute, Turning turn, List<Key> keys) {
        this(target, attribute, turn, "", keys);
    }

    /** Of something else. */
    public Animation of(String other) {
        return new Animation(other, attribute, turn, path, keys);
    }

    /** With other keys. */
    public Animation withKeys(List<Key> value) {
        return new Animation(target, attribute, turn, path, value);
    }

    /**
     * Checks a key and the one behind it.
     *
     * @throws IllegalArgumentException unless it is later, and has as many numbers
     */
    public static void checkNext(Key key, Key next) {
        Require.that(next.t() > key.t(), "t of a key must be above that of the key before, which is " + Numbers.text(key.t()) + ", but is " + Numbers.text(next.t()));
        int count = key.numbers().length;
        Require.that(next.numbers().length == count,
                "value must have as many numbers as that of the key before, " + count + ", but has " + next.numbers().length);
    }

    /**
     * What can be animated of what stands at a place, in the order of files: the names of its attributes and their values as keys have them.
     *
     * @throws IllegalArgumentException if the scene has nothing there
     */
    public static Map<String, String> values(Scene scene, ScenePath place) {
        return Animations.values(scene, place);
    }

    /** Whether it is of a parameter. */
    public boolean isOfParameter() {
        return target.startsWith(PARAMETER);
    }

    /** The name of the parameter that it is of. */
    public String parameter() {
        return target.substring(PARAMETER.length());
    }

    /**
     * The value at a time; along a path, how far and how high.
     *
     * @param t seconds
     * @return one to three numbers
     */
    public double[] at(double t) {
        return moments().apply(t);
    }

    /** As {@link #at}, for many times: what the keys say is read once. */
    DoubleFunction<double[]> moments() {
        double[][] values = keys.stream().map(Key::numbers).toArray(double[][]::new);
        return t -> at(values, t);
    }

    private double[] at(double[][] values, double t) {
        int next = 0;
        while (next < keys.size() && keys.get(next).t() <= t) {
            next++;
        }
        if (next == 0 || next == keys.size()) {
            return values[Math.max(0, next - 1)].clone();
        }
        Key from = keys.get(next - 1);
        double u = (t - from.t()) / (keys.get(next).t() - from.t());
        return switch (from.ease()) {
            case LINEAR -> between(values[next - 1], values[next], u);
            case SMOOTH -> between(values[next - 1], values[next], u * u * (3 - 2 * u));
            case CATMULL_ROM -> curve(values, next - 1, u);
            case HOLD -> values[next - 1].clone();
        };
    }

    private double[] between(double[] a, double[] b, double share) {
        if (turn == Turning.SHORTEST) {
            Vec3 angles = Quaternion.ofDegrees(new Vec3(a[0], a[1], a[2])).towards(Quaternion.ofDegrees(new Vec3(b[0], b[1], b[2])), share).degrees();
            return new double[] {angles.x(), angles.y(), angles.z()};
        }
        double[] value = a.clone();
        for (int i = 0; i < value.length; i++) {
            value[i] += share * (b[i] - a[i]);
        }
        return value;
    }

    /** Cubic Hermite from a key to the next. */
    private double[] curve(double[][] values, int from, double u) {
        double span = keys.get(from + 1).t() - keys.get(from).t();
        double[] a = values[from];
        double[] b = values[from + 1];
        double[] value = new double[a.length];
        for (int i = 0; i < value.length; i++) {
            double rise = u * u * (3 - 2 * u);
            value[i] = a[i] + rise * (b[i] - a[i]) + u * (1 - u) * span * ((1 - u) * slope(values, from, i) - u * slope(values, from + 1, i));
        }
        return value;
    }

    private double slope(double[][] values, int key, int number) {
        int before = Math.max(0, key - 1);
        int behind = Math.min(keys.size() - 1, key + 1);
        return (values[behind][number] - values[before][number]) / (keys.get(behind).t() - keys.get(before).t());
    }
}
