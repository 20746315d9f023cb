package cz.paprsek.teach;

import static cz.paprsek.teach.mistake.Mistake.NO_ROTATION;
import static cz.paprsek.teach.mistake.Mistake.RADIUS_IS_DIAMETER;
import static cz.paprsek.teach.mistake.Mistake.ROTATION_OPPOSITE;
import static cz.paprsek.teach.mistake.Mistake.ROTATION_ORDER;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Ellipsoid;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.teach.Body.Thing;
import cz.paprsek.teach.mistake.Mistake;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.ArrayList;
import java.util.List;

/** Puts the objects of a scene into the world. */
final class Placing {
    private final Scene scene;
    private final Mistakes made;
    private int next;

    private Placing(Scene scene, Mistakes made) {
        this.scene = scene;
        this.made = made;
    }

    /** The bodies of a scene: those of glass last, so that what lies on glass is seen before it. */
    static List<Body> bodies(Scene scene, Mistakes made) {
        Placing placing = new Placing(scene, made);
        List<Body> bodies = new ArrayList<>();
        for (boolean isGlass : new boolean[] {false, true}) {
            for (SceneObject object : scene.objects()) {
                if (placing.isGlass(object) == isGlass) {
                    Affine toWorld = placing.toParent(object.placement());
                    Paint standard = new Paint(Material.DEFAULT, Affine.IDENTITY, made);
                    Thing thing = placing.place(object.shape(), toWorld, placing.paint(object.material(), toWorld, standard));
                    // Who makes a mistake with shapes may find one outside of its box.
                    Bounds box = made.without(Mistake.Part.SHAPE).equals(made) ? object.shape().bounds().transformed(toWorld).padded() : Bounds.ALL;
                    bodies.add(new Body(thing, object.shape().hasInside(), isGlass, box));
                }
            }
        }
        return bodies;
    }

    private Thing place(Shape shape, Affine toWorld, Paint paint) {
        if (shape instanceof Csg csg) {
            List<Thing> solids = new ArrayList<>();
            csg.operands().forEach(operand -> {
                Affine own = toWorld.after(toParent(operand.placement()));
                solids.add(place(operand.solid(), own, paint(operand.material(), own, paint)));
            });
            return solids.size() == 1 ? solids.get(0) : new Together(csg.operation(), solids, made);
        }
        int number = next++;
        if (shape instanceof Sphere sphere) {
            double radius = made.has(RADIUS_IS_DIAMETER) ? sphere.radius() / 2 : sphere.radius();
            return round(number, paint, toWorld, new Vec3(radius, radius, radius));
        } else if (shape instanceof Ellipsoid ellipsoid) {
            return round(number, paint, toWorld, ellipsoid.semiAxes());
        } else if (shape instanceof Block block) {
            return new Box(number, paint, toWorld, block, made);
        } else if (shape instanceof Cylinder cylinder) {
            return new Drum(number, paint, toWorld, cylinder, made);
        } else if (shape instanceof Plane) {
            return new Ground(number, paint, toWorld);
        } else if (shape instanceof Rectangle || shape instanceof Disc) {
            return new Figure(number, paint, toWorld, shape, made);
        }
        throw new IllegalArgumentException(Unknown.sentence(List.of(shape.kind())));
    }

    /** A ball stays a ball as long as no direction is stretched more than another. */
    private Primitive round(int number, Paint paint, Affine toWorld, Vec3 semiAxes) {
        Affine fromUnit = toWorld.after(Affine.scaling(semiAxes));
        double radius = fromUnit.uniformScale();
        return radius > 0 ? new Ball(number, paint, new Vec(toWorld.xt(), toWorld.yt(), toWorld.zt()), radius, made) : new Oval(number, paint, fromUnit, made);
    }

    private Affine toParent(Placement placement) {
        Vec3 r = placement.rotation();
        if (r.equals(Vec3.ZERO) || !(made.has(NO_ROTATION) || made.has(ROTATION_OPPOSITE) || made.has(ROTATION_ORDER))) {
            return placement.toParent();
        }
        Affine turn = Affine.rotation(made.has(ROTATION_OPPOSITE) ? r.negated() : r);
        if (made.has(ROTATION_ORDER)) {
            turn = Affine.rotation(new Vec3(r.x(), 0, 0)).after(Affine.rotation(new Vec3(0, r.y(), 0))).after(Affine.rotation(new Vec3(0, 0, r.z())));
        }
        return Affine.translation(placement.position()).after(made.has(NO_ROTATION) ? Affine.IDENTITY : turn).after(Affine.scaling(placement.scale()));
    }

    private Paint paint(MaterialSource source, Affine toWorld, Paint inherited) {
        return source == Inherited.INHERITED ? inherited : new Paint(material(source), toWorld.inverse(), made);
    }

    private Material material(MaterialSource source) {
        return source instanceof MaterialName name ? name.in(scene.materials()) : source instanceof Material own ? own : Material.DEFAULT;
    }

    private boolean isGlass(SceneObject object) {
        return object.shape().hasInside() && letsLightThrough(object.shape(), material(object.material()));
    }

    private boolean letsLightThrough(Shape shape, Material material) {
        return shape instanceof Csg csg ? csg.operands().stream().anyMatch(operand ->
                letsLightThrough(operand.solid(), operand.material() == Inherited.INHERITED ? material : material(operand.material())))
                : material.transparency() > 0;
    }
}
