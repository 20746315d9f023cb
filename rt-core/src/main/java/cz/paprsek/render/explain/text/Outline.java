package cz.paprsek.render.explain.text;

import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.TracedRay.Sight;
import cz.paprsek.words.Words;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * A ray with a name, and the rays that it gives rise to; each can be written out as a worked exercise.
 *
 * @param name how the ray came about, letter by letter: E from the eye, R reflected, T transmitted
 * @param share of the ray's light in that of the ray from the eye: the product of the weights on the way, of several channels the greatest, 0–1 for most materials
 * @param children the rays whose light is part of its own
 */
public record Outline(String name, TracedRay ray, double share, List<Outline> children) {
    public Outline {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(ray, "ray");
        children = List.copyOf(children);
    }

    /** The outline of a ray from the eye. */
    public static Outline of(TracedRay ray) {
        return of("E", ray, 1);
    }

    private static Outline of(String name, TracedRay ray, double share) {
        List<Outline> children = new ArrayList<>();
        for (TracedRay child : ray.children()) {
            children.add(of(name + (child.kind() == TracedRay.Kind.REFLECTED ? "R" : "T"), child, share * child.weight().most()));
        }
        return new Outline(name, ray, share, children);
    }

    /** How the ray's light comes about, line by line. */
    public List<Step> steps(Words words) {
        return new Exercise(name, ray, words).steps().stream().map(step -> step.in(words)).toList();
    }

    /** Without the rays below this one whose {@link #share} is smaller. */
    public Outline pruned(double smallestShare) {
        return new Outline(name, ray, share,
                children.stream().filter(child -> child.share() >= smallestShare).map(child -> child.pruned(smallestShare)).toList());
    }

    /** What the ray is and meets, in one line. */
    public String headline(Words words) {
        String kind = switch (ray.kind()) {
            case PRIMARY -> words.of("from-eye");
            case REFLECTED -> words.of("reflected");
            case REFRACTED -> words.of("refracted");
        };
        if (ray.sight().map(Sight::isBlind).orElse(false)) {
            return words.of("sees-nothing");
        }
        if (ray.seen().isPresent()) {
            return kind + inside(words) + words.of("sees-light", ray.seen().get().label());
        }
        if (ray.encounter().isEmpty()) {
            return kind + inside(words) + words.of("sees-background");
        }
        Encounter.Place place = ray.encounter().get().place();
        boolean isInSame = place.fromInside() && ray.medium().isInside(place.surface());
        return kind + (isInSame ? words.of("hits-from-inside", words.surface(place.surface()))
                : inside(words) + words.of("hits", words.surface(place.surface())));
    }

    private String inside(Words words) {
        return ray.medium().solid().map(solid -> words.of("inside", words.surface(solid))).orElse("");
    }

    /** The {@link #share} in percent, for people. */
    public String percent(Words words) {
        return words.figures(Figures.of(100 * share)) + " %";
    }

    /** How many rays there are below this one. */
    public int descendants() {
        return children.stream().mapToInt(child -> 1 + child.descendants()).sum();
    }
}
