package cz.paprsek.fx.model;

import cz.paprsek.scene.Body;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import java.util.Collection;
import java.util.List;
import java.util.Set;

/** Picks out of places. */
public final class Places {
    private Places() {}

    /** The objects and operands that are not within others of these places, in order. */
    public static List<BodyAt> outermost(Collection<? extends ScenePath> places) {
        List<BodyAt> bodies = bodies(places);
        if (bodies.stream().allMatch(body -> body.depth() == 0)) {
            return bodies;
        }
        Set<ScenePath> all = Set.copyOf(places);
        return bodies.stream().filter(body -> body.way().limit(body.depth()).noneMatch(all::contains)).toList();
    }

    /** The objects and operands, in order. */
    public static List<BodyAt> bodies(Collection<? extends ScenePath> places) {
        return only(BodyAt.class, places);
    }

    /** How many bodies are drawn for one: its operands instead of an operation. */
    public static int count(Body body) {
        return body.operands().isEmpty() ? 1 : body.operands().stream().mapToInt(operand -> count(Body.of(operand))).sum();
    }

    /** The cameras, in order. */
    public static List<CameraAt> cameras(Collection<? extends ScenePath> places) {
        return only(CameraAt.class, places);
    }

    /** The lights, in order. */
    public static List<LightAt> lights(Collection<? extends ScenePath> places) {
        return only(LightAt.class, places);
    }

    private static <P extends ScenePath> List<P> only(Class<P> kind, Collection<? extends ScenePath> places) {
        return places.stream().filter(kind::isInstance).map(kind::cast).toList();
    }
}
