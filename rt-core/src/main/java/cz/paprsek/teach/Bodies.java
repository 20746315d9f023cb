package cz.paprsek.teach;

import static cz.paprsek.teach.mistake.Mistake.BEHIND;
import static cz.paprsek.teach.mistake.Mistake.LAST_HIT;
import static cz.paprsek.teach.mistake.Mistake.SMALLER_T;

import cz.paprsek.teach.mistake.Mistakes;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * Finds what a ray meets. Of bodies that lie in one place, as a tumbler and its water, or glass and the table below it, rounding would decide; so a solid is
 * entered from outside only and left from inside, one of glass is entered before the one that touches it is left, and what else touches glass is met when
 * that has been left.
 */
record Bodies(List<Body> all, Mistakes made) {
    /** What is met first. */
    Optional<Met> first(Ray ray, Media media) {
        List<Met> ahead = ahead(ray);
        Optional<Met> atOnce = ray.near() < 0 && !made.has(BEHIND) ? best(ahead, media, met -> met.t() <= ray.contact() && counts(ray, media, met, true)) : Optional.empty();
        if (atOnce.isPresent()) {
            return atOnce;
        }
        Optional<Met> nearest = nearest(ahead, ray);
        return media.all().isEmpty() ? nearest : nearest.flatMap(hit -> amongGlass(hit, ahead, ray, media)).or(() -> nearest);
    }

    /** What stands between the start of a ray and its end. */
    List<Crossing> between(Ray ray, Media media, double end) {
        List<Crossing> found = new ArrayList<>();
        for (Body body : all) {
            for (Crossing crossing : crossings(body, ray)) {
                boolean isMet = crossing.t() > ray.contact() || (crossing.t() > ray.near() && counts(ray, media, new Met(body, crossing), true));
                if (isMet && crossing.t() < end) {
                    found.add(crossing);
                }
            }
        }
        return found;
    }

    private static List<Crossing> crossings(Body body, Ray ray) {
        return body.isNear(ray) ? body.thing.crossings(ray) : List.of();
    }

    private List<Met> ahead(Ray ray) {
        double near = made.has(BEHIND) ? Double.NEGATIVE_INFINITY : ray.near();
        List<Met> ahead = new ArrayList<>();
        for (Body body : all) {
            List<Crossing> crossings = crossings(body, ray);
            boolean isHalf = made.has(SMALLER_T) && body.thing instanceof Primitive && !crossings.isEmpty();
            for (Crossing crossing : isHalf ? crossings.subList(0, 1) : crossings) {
                if (crossing.t() > near && crossing.t() < Double.POSITIVE_INFINITY) {
                    ahead.add(new Met(body, crossing));
                }
            }
        }
        return ahead;
    }

    private Optional<Met> nearest(List<Met> ahead, Ray ray) {
        Met nearest = null;
        for (Met met : ahead) {
            boolean isAhead = met.t() > ray.contact() || made.has(BEHIND);
            boolean isLast = made.has(LAST_HIT) && nearest != null && !nearest.body().equals(met.body());
            if (isAhead && (nearest == null || isLast || isBefore(met, nearest, ray))) {
                nearest = met;
            }
        }
        return Optional.ofNullable(nearest);
    }

    /** Of surfaces in one place, that with the lower number comes first. */
    private static boolean isBefore(Met met, Met other, Ray ray) {
        double touch = ray.touch(other.t());
        return met.t() < other.t() + touch && (met.number() < other.number() || met.t() < other.t() - touch);
    }

    /** What is met in the place of a hit within glass, if not the hit itself. */
    private Optional<Met> amongGlass(Met hit, List<Met> ahead, Ray ray, Media media) {
        double touch = ray.touch(hit.t());
        Predicate<Met> isHere = met -> met.t() > hit.t() - touch && met.t() < hit.t() + touch && counts(ray, media, met, false);
        if (hit.body().isGlass && !media.hold(hit.body())) {
            return Optional.empty();
        }
        return best(ahead, media, met -> isHere.test(met) && (hit.body().isGlass ? rank(media, met) < 2 : media.hold(met.body())));
    }

    private static Optional<Met> best(List<Met> ahead, Media media, Predicate<Met> counts) {
        return ahead.stream().filter(counts).min(Comparator.<Met>comparingInt(met -> rank(media, met)).thenComparingInt(Met::number))
                .map(met -> new Met(met.body(), met.crossing().at(Math.max(0, met.t()))));
    }

    private static int rank(Media media, Met met) {
        return !met.body().isGlass || media.all().isEmpty() ? 2 : media.hold(met.body()) ? 1 : 0;
    }

    /** Whether a ray meets a surface that lies in one place with others. */
    private static boolean counts(Ray ray, Media media, Met met, boolean atStart) {
        if (met.body().isSolid) {
            boolean isEntry = met.crossing().isEntry(ray);
            boolean isPassed = isEntry && atStart && ray.beyond() && met.t() <= 0 && media.passed().contains(met.body());
            return isEntry != media.hold(met.body()) && !isPassed;
        } else if (!atStart) {
            return true;
        }
        Met from = Objects.requireNonNull(ray.from());
        return ray.beyond() ? met.number() > from.number() || (from.body().isGlass && !media.hold(from.body()))
                : met.number() < from.number() && !media.hold(from.body());
    }

    /** A body, and where it is crossed. */
    record Met(Body body, Crossing crossing) {
        double t() {
            return crossing.t();
        }

        int number() {
            return crossing.of().number;
        }
    }
}
