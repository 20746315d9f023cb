package cz.paprsek.shape;

import cz.paprsek.math.Affine;
import cz.paprsek.shape.height.HeightField;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Volume;

/** A shape with an inside, which can therefore be an operand of CSG. */
public sealed interface Solid extends Shape permits Sphere, Block, Ellipsoid, Plane, Cylinder, Cone, Torus, Capsule, Prism, Superellipsoid, Extrude, Lathe, Text, Isosurface, HeightField, Mesh, Csg, CustomSolid {

    @Override
    Volume place(Affine toWorld, Parts parts);
}
