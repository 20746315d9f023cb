package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SunLight;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** Makes shadows softer, by lights that have a size, or a larger one, and as much light as before. */
public final class Softness {
    /** The radius of a ball that a point becomes, as a share of the distance to what the user looks at. */
    private static final double SHARE = 0.08;
    /** The disc of a sun that had none, degrees: four times the real one's. */
    private static final double DISC = 2;
    /** How much larger a light becomes that has a size. */
    private static final double LARGER = 1.5;
    /** The largest disc that a hand makes, degrees. */
    private static final double WIDEST = 60;

    private Softness() {}

    /**
     * Softer shadows of some of a scene's lights, or of all of them if none is named.
     *
     * @throws IllegalArgumentException if none of them can have a size
     */
    public static Scene softened(EditorState state, List<LightAt> lights) {
        Scene scene = state.scene();
        Vec3 seen = Sight.of(state).point();
        List<Light> softer = new ArrayList<>(scene.lights());
        IntStream.range(0, softer.size()).filter(i -> lights.isEmpty() || lights.stream().anyMatch(at -> at.index() == i))
                .forEach(i -> softer.set(i, softened(softer.get(i), seen)));
        if (softer.equals(scene.lights())) {
            throw new IllegalArgumentException("there is no light here that could give softer shadows");
        }
        return scene.withLights(softer);
    }

    /** @param seen where a point light that does not fall off has the light it has: what the user looks at */
    private static Light softened(Light light, Vec3 seen) {
        if (light instanceof PointLight point) {
            double distance = Math.max(rounded(point.position().minus(seen).length()), 1e-3);
            return SphereLight.of(point.position(), rounded(SHARE * distance)).named(point.name()).withColor(point.color()).withIntensity(point.intensity())
                    .withReferenceDistance(point.fallOff().orElse(distance)).withVisible(false);
        } else if (light instanceof SphereLight ball) {
            return ball.withRadius(rounded(LARGER * ball.radius()));
        } else if (light instanceof AreaLight area && area.form() instanceof AreaLight.Size size) {
            return area.withForm(new AreaLight.Size(rounded(LARGER * size.width()), rounded(LARGER * size.height())));
        } else if (light instanceof AreaLight area && area.form() instanceof AreaLight.Radius round) {
            return area.withForm(new AreaLight.Radius(rounded(LARGER * round.radius())));
        }
        return light instanceof SunLight sun ? sun.withDisc(sun.angle() > 0 ? Math.max(sun.angle(), Math.min(WIDEST, rounded(LARGER * sun.angle()))) : DISC, sun.visible()) : light;
    }

    private static double rounded(double value) {
        return BigDecimal.valueOf(value).round(new MathContext(3)).doubleValue();
    }
}
