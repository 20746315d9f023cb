/** STL, in text and in bytes: triangles and nothing else. Millimetres with z up, by custom. */
@NullMarked
package cz.paprsek.format.stl;

import org.jspecify.annotations.NullMarked;
