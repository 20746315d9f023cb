/** OpenSCAD's dumps (CSG): a tree of bodies and operations, as bodies and operations of ours. Millimetres with z up. */
package cz.paprsek.format.openscad;
