package cz.paprsek.render.buffer;

import cz.paprsek.math.Vec3;
import org.jspecify.annotations.Nullable;

/**
 * Where all light of a lamp comes from.
 *
 * @param at a point, world space; or of a light endlessly far away its direction, towards the light, of length 1
 */
public record LightPlace(Vec3 at, boolean isFar) {
    /** As that of any record, but at hand: what makes those of records takes long the first time. */
    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof LightPlace place && isFar == place.isFar && at.equals(place.at);
    }

    @Override
    public int hashCode() {
        return 2 * at.hashCode() + (isFar ? 1 : 0);
    }
}
