package cz.paprsek.fx.model.edit;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PlacedLight;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Placement;
import java.util.function.UnaryOperator;

/** Moves, turns and stretches lights in world space. A sun stands nowhere: hands have it where its direction, drawn as an arrow, leads to the origin. */
public final class LightMoves {
    /** Angles that follow from where a hand is are of this coarseness, so that they can be read. */
    private static final double DEGREES = 0.5;

    private LightMoves() {}

    /** Where a light is for hands. */
    public static Vec3 place(Light light) {
        return light instanceof PlacedLight placed ? placed.position() : light instanceof SunLight sun ? sun.direction().negated() : Vec3.ZERO;
    }

    /** A light taken to where a map takes its place. One that has a target goes on shining at it. */
    static Light moved(Light light, UnaryOperator<Vec3> point) {
        if (light instanceof PlacedLight placed) {
            return placed.withPosition(point.apply(placed.position()));
        }
        return light instanceof SunLight sun ? sun.withDirection(point.apply(place(sun)).negated()) : light;
    }

    /** A light that shines at a point: a spot, or one with a side. Others stay as they are. */
    public static Light shiningAt(Light light, Vec3 point) {
        if (light instanceof SpotLight spot) {
            return spot.withAim(spot.aim() instanceof Camera.Target ? new Camera.Target(point) : new Camera.Direction(point.minus(spot.position())));
        } else if (light instanceof AreaLight area) {
            Vec3 turned = area.shiningAt(point).rotation();
            return area.withRotation(new Vec3(readable(turned.x()), readable(turned.y()), 0));
        }
        return light;
    }

    /** A spot with another outer angle, in degrees, and the inner one in proportion. */
    public static SpotLight widened(SpotLight spot, double outer) {
        return spot.withAngles(Math.min(outer, readable(spot.fullAngle() * outer / spot.outerAngle())), outer);
    }

    private static double readable(double degrees) {
        return Math.rint(degrees / DEGREES) * DEGREES + 0.0;
    }

    /** A light turned. */
    static Light turned(Light light, Affine turn) {
        Light moved = moved(light, turn::point);
        if (moved instanceof SpotLight spot && spot.aim() instanceof Camera.Direction direction) {
            return spot.withAim(new Camera.Direction(Moves.rounded(turn.direction(direction.vector()))));
        } else if (moved instanceof AreaLight area) {
            Affine linear = Moves.linear(turn).after(Affine.rotation(area.rotation()));
            return Placements.of(linear).map(Placement::rotation).map(area::withRotation).orElse(area);
        }
        return moved;
    }

    /** A light stretched: its size too, alike in all directions if it stands askew. */
    static Light stretched(Light light, Affine stretch, Vec3 factors, double even) {
        Light moved = moved(light, stretch::point);
        if (moved instanceof SphereLight ball) {
            return ball.withRadius(Moves.rounded(ball.radius() * even));
        } else if (moved instanceof AreaLight area && area.form() instanceof AreaLight.Radius round) {
            return area.withForm(new AreaLight.Radius(Moves.rounded(round.radius() * even)));
        } else if (moved instanceof AreaLight area && area.form() instanceof AreaLight.Size size) {
            Affine own = Affine.rotation(area.rotation());
            Vec3 along = own.keepsAxes() ? Moves.ownFactors(own, factors) : new Vec3(even, even, even);
            return area.withForm(new AreaLight.Size(Moves.rounded(size.width() * along.x()), Moves.rounded(size.height() * along.y())));
        }
        return moved;
    }
}
