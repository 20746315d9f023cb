package cz.paprsek.teach;

import java.util.List;

/** What a ray's line can cross: a primitive, or solids put together. */
interface Thing {
    /** Where the whole line of a ray crosses the surface, in order; a solid is entered and left in turn. */
    List<Crossing> crossings(Ray ray);
}
