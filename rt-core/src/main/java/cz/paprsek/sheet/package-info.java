/** Worksheets: pixels of a scene as exercises to be done with a pocket calculator, and their solutions. */
package cz.paprsek.sheet;
