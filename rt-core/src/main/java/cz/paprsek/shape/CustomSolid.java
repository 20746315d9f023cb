package cz.paprsek.shape;

import cz.paprsek.math.Affine;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.placed.Made;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Volume;

/**
 * A solid that is made in code rather than read from a file, and takes part in CSG, glass and shadows like any other. Must be immutable; any
 * number of workers ask it at once.
 */
public non-sealed interface CustomSolid extends Solid, CustomShape {

    /**
     * Calls {@link Line#cross} for every place where the line enters or leaves the solid, in turn, from minus to plus infinity in rising order,
     * whatever the length of its direction. What the line only touches is left out. Of the line's start nothing need be left out: who starts there is known.
     */
    @Override
    void cross(Line line);

    @Override
    default Volume place(Affine toWorld, Parts parts) {
        return new Made.Body(parts.add(part -> new Made(part, toWorld, this)));
    }
}
