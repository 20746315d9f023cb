package cz.paprsek.material;

import cz.paprsek.ray.Hit;
import cz.paprsek.text.MadeInCode;
import java.util.List;

/**
 * A pattern that is made in code rather than read from a file. Must be immutable; any number of workers ask it at once. Scene files and POV-Ray
 * cannot hold it.
 */
public non-sealed interface CustomPattern extends Pattern {

    /** The word for its kind in lists, explanations and messages: the name of its class unless it says otherwise. */
    @Override
    default String kind() {
        return MadeInCode.kind(this);
    }

    @Override
    default List<Rgb> palette() {
        return List.of();
    }

    /**
     * Sets the colour at a hit, in linear light, by {@link Hit#color}.
     *
     * @param x the point in the space of the object that has the material, before its placement
     * @param hit the point and the normals in the world; u, v and the tangent only if {@link #isMapped}
     */
    void color(double x, double y, double z, Hit hit);
}
