/** STL, in text and in bytes: triangles and nothing else. Millimetres with z up, by custom. */
package cz.paprsek.format.stl;
