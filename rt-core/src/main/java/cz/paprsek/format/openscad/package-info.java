/** OpenSCAD's dumps (CSG): a tree of bodies and operations, as bodies and operations of ours. Millimetres with z up. */
@NullMarked
package cz.paprsek.format.openscad;

import org.jspecify.annotations.NullMarked;
