package cz.paprsek.teach.grade;

import cz.paprsek.image.Image;
import cz.paprsek.image.StoredImage;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import cz.paprsek.teach.PlainTracer;
import cz.paprsek.teach.grade.Grade.Verdict;
import cz.paprsek.teach.mistake.Mistake;
import cz.paprsek.teach.mistake.Mistake.Part;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Says which mistakes explain a picture of a scene best, one or two of them. Every mistake is rendered once, at a few hundred pixels of the very size of the
 * picture, among them some that are wrong; what comes near is looked at at more. Of two mistakes, one at least explains something by itself: the five best are
 * tried with all others. Where light takes hundreds of rays, nothing is looked at,
 * and of scenes with many bodies fewer pixels are.
 */
public final class Grader {
    private static final int FEW = 150;
    /** Of pairs, which are thousands, some are left after a glance at so many pixels of each kind. */
    private static final int GLANCE = 25;
    private static final int GLANCED = 60;
    private static final int MANY = 1500;
    /** Of scenes with more primitives, each of which every ray of the plain tracer is tried with, fewer pixels are looked at. */
    private static final int SMALL = 40;
    /** So many mistakes are tried together with all others. */
    private static final int LIKELY = 5;
    private static final int REFINED = 10;
    /** Nearer than this is the same: a pixel in a thousand may be any. */
    private static final double SAME = 0.001;
    /** What changes less does not show in a scene. */
    private static final double SHOWS = 0.0003;
    /** Two mistakes are believed only if they leave less than this share of what one leaves. */
    private static final double MUCH_BETTER = 0.6;
    /** Mistakes that leave more than this share of what is wrong explain nothing. */
    private static final double MOST_LEFT = 0.4;
    /** Farther than this from right is wrong, whether anything explains it or not. */
    private static final double RATHER_RIGHT = 0.03;

    private final List<Look> looks;

    /** Is told how far the search is; by any thread. */
    @FunctionalInterface
    public interface Watcher {
        /** Whoever does not wish to know. */
        Watcher NONE = (samples, together, done, all) -> {};

        /**
         * So many are tried, with as many rays; with one ray a pixel, all may be tried before they are with more.
         *
         * @param samples how many rays along a pixel's side
         * @param together how many mistakes each of them has, 1 or 2
         */
        void tried(int samples, int together, int done, int all);
    }

    /** Counts what is tried. */
    private record Count(Watcher watcher, int samples, int together, int all, AtomicInteger done) {
        Count(Watcher watcher, int samples, int together, int all) {
            this(watcher, samples, together, all, new AtomicInteger());
        }

        <T> T one(T tried) {
            watcher.tried(samples, together, done.incrementAndGet(), all);
            return tried;
        }
    }

    /** One number of rays along a pixel's side. */
    private static final class Look {
        final int samples;
        final Attempts attempts;
        final int[] many;

        Look(Scene scene, RenderSettings settings, BooleanSupplier stop) {
            samples = settings.samples();
            int most = MANY * SMALL / Math.max(SMALL, Math.min(5 * SMALL, primitives(scene)));
            attempts = new Attempts(scene, settings, Places.of(settings.width(), settings.height(), most), stop);
            many = IntStream.range(0, attempts.places().count()).toArray();
        }
    }

    private static int primitives(Scene scene) {
        return scene.objects().stream().map(SceneObject::shape).mapToInt(Grader::primitives).sum();
    }

    private static int primitives(Shape shape) {
        return shape instanceof Csg csg ? csg.operands().stream().map(Operand::solid).mapToInt(Grader::primitives).sum() : 1;
    }

    private record Candidate(Mistakes made, double left) {}

    /**
     * For pictures of a scene in one size.
     *
     * @param areSamplesKnown whether the pictures have the samples of these settings; else one ray a pixel is tried, too
     * @throws IllegalArgumentException if the plain tracer does not know all of the scene, saying what
     */
    public Grader(Scene scene, RenderSettings settings, boolean areSamplesKnown, BooleanSupplier stop) {
        PlainTracer.of(scene, settings, Mistakes.NONE);
        Objects.requireNonNull(stop, "stop");
        looks = Stream.of(areSamplesKnown ? settings.samples() : 1, settings.samples()).distinct().map(n -> new Look(scene, settings.withSamples(n), stop)).toList();
    }

    /**
     * What there is to say of a picture.
     *
     * @throws IllegalArgumentException if its size is not the one
     */
    public Grade grade(StoredImage picture) {
        return grade(picture, Watcher.NONE);
    }

    /**
     * As {@link #grade(StoredImage)}, telling how far it is.
     *
     * @throws IllegalArgumentException if the picture's size is not the one
     */
    public Grade grade(StoredImage picture, Watcher watcher) {
        Objects.requireNonNull(watcher, "watcher");
        Image image = picture.image();
        Grade best = null;
        for (Look look : looks) {
            Places places = look.attempts.places();
            if (places.width() != image.width() || places.height() != image.height()) {
                throw new IllegalArgumentException("the picture is " + image.width() + " x " + image.height() + " pixels, not " + places.width() + " x " + places.height());
            }
            Grade grade = new Judging(look, image, picture.isGrey(), watcher).grade();
            if (best == null || rank(grade) > rank(best)) {
                best = grade;
            }
            if (grade.verdict() == Verdict.RIGHT) {
                break;
            }
        }
        return Objects.requireNonNull(best);
    }

    /** As within one number of rays, two mistakes count for more than one only if they leave much less. */
    private static double rank(Grade grade) {
        boolean isPair = grade.explanations().stream().anyMatch(one -> one.all().size() > 1);
        return grade.verdict() == Verdict.RIGHT ? 2 : (grade.explained() - 1) / (isPair ? MUCH_BETTER : 1);
    }

    /** The mistakes that do not show in the scene, in pictures of this size. */
    public Set<Mistake> silent() {
        Look look = looks.get(0);
        Sheet right = look.attempts.with(Mistakes.NONE, look.many, false);
        Set<Mistake> silent = new LinkedHashSet<>(List.of(Mistake.values()));
        silent.removeIf(mistake -> look.attempts.with(Mistakes.of(mistake), look.many, false).distance(right) > SHOWS);
        return silent;
    }

    /** One picture, with one number of rays. */
    private static final class Judging {
        private final Look look;
        private final boolean isGrey;
        private final Sheet many;
        /** Some pixels all over the picture, and some of those that are wrong. */
        private final int[] telling;
        private final Sheet few;
        private final int[] glanced;
        private final Sheet glance;
        private final Watcher watcher;

        Judging(Look look, Image image, boolean isGrey, Watcher watcher) {
            this.look = look;
            this.isGrey = isGrey;
            this.watcher = watcher;
            this.many = Sheet.of(image, look.attempts.places(), look.many, isGrey);
            Sheet right = look.attempts.with(Mistakes.NONE, look.many, isGrey);
            this.telling = telling(right, FEW);
            this.few = Sheet.of(image, look.attempts.places(), telling, isGrey);
            this.glanced = telling(right, GLANCE);
            this.glance = Sheet.of(image, look.attempts.places(), glanced, isGrey);
        }

        private int[] telling(Sheet right, int each) {
            return IntStream.concat(IntStream.range(0, Math.min(each, look.many.length)),
                    IntStream.of(look.many).filter(i -> many.distance(right, i) > 0).limit(each)).distinct().toArray();
        }

        Grade grade() {
            Candidate right = refined(Mistakes.NONE);
            if (right.left < SAME) {
                return new Grade(Verdict.RIGHT, List.of(), 1, look.samples);
            }
            Sheet rightOnes = look.attempts.with(Mistakes.NONE, telling, isGrey);
            Count count = new Count(watcher, look.samples, 1, Mistake.values().length);
            List<Candidate> singles = Stream.of(Mistake.values()).parallel().map(Mistakes::of)
                    .filter(one -> count.one(look.attempts.with(one, telling, isGrey).distance(rightOnes)) > SHOWS).map(this::rough).sorted(Comparator.comparingDouble(Candidate::left)).toList();
            List<Candidate> best = best(singles);
            if (best.isEmpty() || best.get(0).left >= SAME) {
                List<Candidate> pairs = best(pairs(singles));
                double single = best.isEmpty() ? 1 : best.get(0).left;
                best = !pairs.isEmpty() && pairs.get(0).left < MUCH_BETTER * single ? pairs : best;
            }
            double left = best.isEmpty() ? 1 : best.get(0).left / right.left;
            if (left > MOST_LEFT) {
                return new Grade(right.left < RATHER_RIGHT ? Verdict.RIGHT : Verdict.UNEXPLAINED, List.of(), 0, look.samples);
            }
            return new Grade(Verdict.MISTAKEN, best.stream().map(Candidate::made).toList(), 1 - left, look.samples);
        }

        /** The best, and those that cannot be told from it. */
        private List<Candidate> best(List<Candidate> rough) {
            List<Candidate> refined = rough.stream().limit(REFINED).parallel().map(one -> refined(one.made)).sorted(Comparator.comparingDouble(Candidate::left)).toList();
            if (refined.isEmpty()) {
                return List.of();
            }
            Sheet first = look.attempts.with(refined.get(0).made, look.many, isGrey);
            return refined.stream().filter(one -> look.attempts.with(one.made, look.many, isGrey).distance(first) < SHOWS).toList();
        }

        private List<Candidate> pairs(List<Candidate> singles) {
            Set<Mistakes> pairs = new LinkedHashSet<>();
            IntStream.range(0, singles.size()).forEach(i -> singles.subList(i + 1, singles.size()).stream().map(Candidate::made)
                    .filter(other -> i < LIKELY || isCheap(other) || isCheap(singles.get(i).made) || (isOfEye(other) && isOfEye(singles.get(i).made)))
                    .forEach(other -> pairs.add(singles.get(i).made.and(other.all().iterator().next()))));
            Count count = new Count(watcher, look.samples, 2, pairs.size());
            List<Candidate> likely = pairs.stream().parallel().map(pair -> count.one(glanced(pair))).sorted(Comparator.comparingDouble(Candidate::left)).limit(GLANCED).toList();
            return likely.stream().parallel().map(one -> rough(one.made)).sorted(Comparator.comparingDouble(Candidate::left)).toList();
        }

        private static boolean isCheap(Mistakes one) {
            return one.all().iterator().next().part() == Part.PICTURE;
        }

        private static boolean isOfEye(Mistakes one) {
            return one.all().iterator().next().part() == Part.EYE;
        }

        private Candidate glanced(Mistakes made) {
            return new Candidate(made, look.attempts.with(made, glanced, isGrey).distance(glance));
        }

        private Candidate rough(Mistakes made) {
            return new Candidate(made, look.attempts.with(made, telling, isGrey).distance(few));
        }

        private Candidate refined(Mistakes made) {
            return new Candidate(made, look.attempts.with(made, look.many, isGrey).distance(many));
        }
    }
}
