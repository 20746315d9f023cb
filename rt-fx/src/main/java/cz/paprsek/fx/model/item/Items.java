package cz.paprsek.fx.model.item;

import cz.paprsek.fx.model.item.Item.BodyAt;
import cz.paprsek.fx.model.item.Item.CameraAt;
import cz.paprsek.fx.model.item.Item.LightAt;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Picks out of items. */
public final class Items {
    private Items() {}

    /** The objects and operands among items that are not within others of them, in order. */
    public static List<BodyAt> outermost(Collection<? extends Item> items) {
        Set<Item> all = new HashSet<>(items);
        return bodies(items).stream().filter(body -> !hasAncestorIn(all, body)).toList();
    }

    /** The objects and operands among items, in order. */
    public static List<BodyAt> bodies(Collection<? extends Item> items) {
        return items.stream().filter(BodyAt.class::isInstance).map(BodyAt.class::cast).toList();
    }

    /** The cameras among items, in order. */
    public static List<CameraAt> cameras(Collection<? extends Item> items) {
        return items.stream().filter(CameraAt.class::isInstance).map(CameraAt.class::cast).toList();
    }

    /** The lights among items, in order. */
    public static List<LightAt> lights(Collection<? extends Item> items) {
        return items.stream().filter(LightAt.class::isInstance).map(LightAt.class::cast).toList();
    }

    private static boolean hasAncestorIn(Set<Item> all, BodyAt body) {
        for (BodyAt at = body; at.depth() > 0; ) {
            at = at.parent();
            if (all.contains(at)) {
                return true;
            }
        }
        return false;
    }
}
