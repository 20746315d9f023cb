/**
 * Trees of boxes: which of many things a ray can meet, without asking all. What the things are, who builds a tree knows: bodies of a scene,
 * operands of a union. Knows neither rays nor shapes, only lines o + t·d and boxes.
 */
@NullMarked
package cz.paprsek.tree;

import org.jspecify.annotations.NullMarked;
