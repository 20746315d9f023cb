package cz.paprsek.shape;

/** A shape with an inside, which can therefore be an operand of CSG. */
public sealed interface Solid extends Shape permits Sphere, Block, Ellipsoid, Plane, Cylinder, Cone, Torus, Csg {}
