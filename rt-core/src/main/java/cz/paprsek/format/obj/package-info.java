/** Wavefront's OBJ, and the materials (MTL) beside it. No unit; y up, by custom. */
package cz.paprsek.format.obj;
