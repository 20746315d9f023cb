package cz.paprsek.xml.bind;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.xml.format.ColorWords;
import jakarta.xml.bind.annotation.adapters.XmlAdapter;
import java.util.StringTokenizer;
import org.jspecify.annotations.Nullable;

/** How the texts of attributes become values. The schema has already seen to their form. */
final class Adapters {
    private Adapters() {}

    /** Numbers separated by white space. */
    static double[] numbers(String text) {
        StringTokenizer words = new StringTokenizer(text);
        double[] numbers = new double[words.countTokens()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = Double.parseDouble(words.nextToken());
        }
        return numbers;
    }

    private static void expect(double[] numbers, int count) {
        if (numbers.length != count) {
            throw new IllegalArgumentException("expected " + count + " numbers, but found " + numbers.length);
        }
    }

    /** One direction only: the writer has no use for beans. */
    abstract static class Reading<T> extends XmlAdapter<String, T> {
        /** @throws IllegalArgumentException if there are too few or too many, or the value does not take them */
        abstract T of(double[] numbers);

        @Override
        public T unmarshal(String text) {
            return of(numbers(text));
        }

        @Override
        public @Nullable String marshal(T value) {
            throw new UnsupportedOperationException("beans are only read");
        }
    }

    static final class Vector extends Reading<Vec3> {
        @Override
        Vec3 of(double[] n) {
            expect(n, 3);
            return new Vec3(n[0], n[1], n[2]);
        }
    }

    static final class Scale extends Reading<Vec3> {
        @Override
        Vec3 of(double[] n) {
            expect(n, n.length == 1 ? 1 : 3);
            return n.length == 1 ? new Vec3(n[0], n[0], n[0]) : new Vec3(n[0], n[1], n[2]);
        }
    }

    static final class Color extends Reading<Rgb> {
        @Override
        public Rgb unmarshal(String text) {
            String word = text.strip();
            return ColorWords.isWord(word) ? ColorWords.of(word) : super.unmarshal(text);
        }

        @Override
        Rgb of(double[] n) {
            expect(n, 3);
            return new Rgb(n[0], n[1], n[2]);
        }
    }

    /** A whole number, or two with two dots between; 0 for the second if it is not there. */
    static final class FromTo extends XmlAdapter<String, int[]> {
        @Override
        public int[] unmarshal(String text) {
            String[] numbers = text.strip().split("\\.\\.", 2);
            return new int[] {Integer.parseInt(numbers[0]), numbers.length == 1 ? 0 : Integer.parseInt(numbers[1])};
        }

        @Override
        public @Nullable String marshal(int[] value) {
            throw new UnsupportedOperationException("beans are only read");
        }
    }

    static final class Pair extends Reading<double[]> {
        @Override
        double[] of(double[] n) {
            expect(n, 2);
            Require.finite("x", n[0]);
            Require.finite("y", n[1]);
            return n;
        }
    }
}
