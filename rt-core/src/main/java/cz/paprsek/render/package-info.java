/**
 * From a scene to an image: the prepared scene, its hierarchy, shading and optics, and the workers.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
@NullMarked
package cz.paprsek.render;

import org.jspecify.annotations.NullMarked;
