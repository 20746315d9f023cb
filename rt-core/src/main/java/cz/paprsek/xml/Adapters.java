package cz.paprsek.xml;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
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

    /** One direction only: files are written by {@link SceneWriter}. */
    private abstract static class Reading<T> extends XmlAdapter<String, T> {
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
            return new Vec3(n[0], n[1], n[2]);
        }
    }

    static final class Scale extends Reading<Vec3> {
        @Override
        Vec3 of(double[] n) {
            return n.length == 1 ? new Vec3(n[0], n[0], n[0]) : new Vec3(n[0], n[1], n[2]);
        }
    }

    static final class Color extends Reading<Rgb> {
        @Override
        Rgb of(double[] n) {
            return new Rgb(n[0], n[1], n[2]);
        }
    }

    static final class Pair extends Reading<double[]> {
        @Override
        double[] of(double[] n) {
            return n;
        }
    }
}
