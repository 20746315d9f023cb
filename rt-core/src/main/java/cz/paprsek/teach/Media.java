package cz.paprsek.teach;

import java.util.List;
import java.util.stream.Stream;

/**
 * The bodies of glass that a ray is inside of, in the order in which it entered them. The index of the last one counts.
 *
 * @param passed those that it has left in the place where it is
 */
record Media(List<Entered> all, List<Body> passed) {
    static final Media NONE = new Media(List.of(), List.of());

    record Entered(Body body, double index) {}

    double index() {
        return all.isEmpty() ? 1 : all.get(all.size() - 1).index();
    }

    boolean hold(Body body) {
        return all.stream().anyMatch(entered -> entered.body().equals(body));
    }

    Media entering(Body body, double index) {
        return new Media(Stream.concat(without(body), Stream.of(new Entered(body, index))).toList(), passed);
    }

    Media leaving(Body body) {
        return new Media(without(body).toList(), Stream.concat(passed.stream(), Stream.of(body)).toList());
    }

    /** In another place. */
    Media elsewhere() {
        return new Media(all, List.of());
    }

    private Stream<Entered> without(Body body) {
        return all.stream().filter(entered -> !entered.body().equals(body));
    }
}
