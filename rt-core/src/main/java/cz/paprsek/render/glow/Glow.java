package cz.paprsek.render.glow;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Affine;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.light.Lamp;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PlacedLight;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.placed.Flat;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Surface;
import java.util.Optional;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;

/** A light that is seen: a black body that shows its radiance on the side it shines to. Immutable. */
final class Glow {
    /** The number of the light in the scene. */
    final int lamp;
    final Surface surface;
    /** The same, if it is flat. */
    private final @Nullable Flat flat;
    private final Part part;
    /** Of the part. */
    private final int number;
    private final double red;
    private final double green;
    private final double blue;

    private Glow(int lamp, Light light, double radiance, Surface surface, Part part, int number) {
        this.lamp = lamp;
        this.number = number;
        this.surface = surface;
        this.flat = surface instanceof Flat one ? one : null;
        this.part = part;
        double k = Math.min(radiance, Lamp.MOST) * light.intensity();
        red = k * light.color().linearRed();
        green = k * light.color().linearGreen();
        blue = k * light.color().linearBlue();
    }

    /**
     * What is seen of a light as a body; empty if it is none.
     *
     * @param part the number of its only part
     */
    static Optional<Glow> of(int lamp, Light light, int part) {
        if (light instanceof AreaLight area && area.visible()) {
            double square = area.referenceDistance() * area.referenceDistance();
            return Optional.of(of(lamp, area, Math.PI * square / area.form().area(), shape(area.form()), area.placement().toParent(), part));
        } else if (light instanceof SphereLight ball && ball.visible()) {
            double by = ball.referenceDistance() / ball.radius();
            return Optional.of(of(lamp, ball, by * by, new Sphere(ball.radius()), Affine.translation(ball.position()), part));
        }
        return Optional.empty();
    }

    private static Shape shape(AreaLight.Form form) {
        return form instanceof AreaLight.Size size
                ? new Rectangle(-size.width() / 2, -size.height() / 2, size.width() / 2, size.height() / 2)
                : new Disc(((AreaLight.Radius) form).radius());
    }

    private static Glow of(int lamp, PlacedLight light, double radiance, Shape shape, Affine toWorld, int number) {
        Single single = new Single(number);
        Surface surface = shape.place(toWorld, single);
        return new Glow(lamp, light, radiance, surface, single.part(), number);
    }

    /** Makes this light the ray's hit, unless something else is met before, or a later light in the same place. */
    void nearest(Ray ray, int firstPart) {
        if (flat != null && flat.isApart(ray)) {
            return;
        }
        int before = ray.part;
        double max = ray.max;
        boolean isOfLaterLight = before >= firstPart && before > number;
        // Of hits in one place that of the lowest part counts.
        ray.part = before < 0 ? before : isOfLaterLight ? 0 : Integer.MAX_VALUE;
        surface.nearest(ray);
        ray.part = isOfLaterLight ? ray.max < max ? number : before : ray.part == Integer.MAX_VALUE ? before : ray.part;
    }

    /** Says where the surface was hit. */
    void describe(int face, Hit hit) {
        part.describe(face, hit);
    }

    /** The light that is seen of it, from before or behind. */
    void shine(boolean isBehind, Arrival out) {
        double k = isBehind ? 0 : 1;
        out.light(k * red, k * green, k * blue);
    }

    /** Numbers the one part of a shape. */
    private static final class Single implements Parts {
        private final int number;
        private @Nullable Part made;

        Single(int number) {
            this.number = number;
        }

        Part part() {
            if (made == null) {
                throw new IllegalStateException("a light's shape has no part");
            }
            return made;
        }

        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            P part = maker.apply(number);
            made = part;
            return part;
        }

        @Override
        public Parts within(MaterialSource material, Affine toWorld) {
            return this;
        }
    }
}
