/** Heights over a grid: relief that is met cell by cell. */
package cz.paprsek.shape.height;
