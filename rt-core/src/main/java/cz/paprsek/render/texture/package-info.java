/** Pictures as they lie on surfaces and in the sky: looked up at a point, or as the mean over the footprint of a pixel. */
package cz.paprsek.render.texture;
