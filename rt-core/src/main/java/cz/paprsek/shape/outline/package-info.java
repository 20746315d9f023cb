/** Outlines in the plane, how lines meet them, and the solids that are made of them, ready for rays. */
package cz.paprsek.shape.outline;
