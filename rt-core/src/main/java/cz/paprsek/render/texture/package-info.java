/** What lies on surfaces and in the sky: pictures, looked up at a point or as the mean over the footprint of a pixel, and values of patterns at a point of space. */
@NullMarked
package cz.paprsek.render.texture;

import org.jspecify.annotations.NullMarked;
