package cz.paprsek.render.explain;

import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Shape;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * A ray has hit something: where, what it is made of, and the terms of the light that the ray takes back from there.
 *
 * @param place where
 * @param material what the surface is made of at this point: its shares are numbers
 * @param readings what its patterns have at this point: that of the colour first, then those of shares, and of bumps
 * @param color C, the surface's colour at this point
 * @param ambientLight A, the scene's light that reaches every point alike
 * @param ambient the ambient term, A·C
 * @param emitted light that the surface gives off of its own
 * @param lights the term of each light; empty if the material shows no light that falls on it
 * @param refraction what becomes of the ray at a transparent surface; empty at an opaque one, and where the depth ends
 * @param split how much is mirrored at this angle; empty if that does not depend on the angle, and where the depth ends
 * @param facet by which facet of a rough surface the ray goes on
 * @param reflected the mirrored ray
 * @param refracted the ray that goes on beyond the surface
 * @param cutOff whether there would be more rays, had the depth allowed for them
 */
public record Encounter(
        Place place,
        Material material,
        List<Reading> readings,
        LinearRgb color,
        LinearRgb ambientLight,
        LinearRgb ambient,
        LinearRgb emitted,
        List<LightTerm> lights,
        Optional<Refraction> refraction,
        Optional<Split> split,
        Optional<Facet> facet,
        Optional<TracedRay> reflected,
        Optional<TracedRay> refracted,
        boolean cutOff) {

    public Encounter {
        Objects.requireNonNull(place, "place");
        Objects.requireNonNull(material, "material");
        Objects.requireNonNull(color, "color");
        Objects.requireNonNull(ambientLight, "ambientLight");
        Objects.requireNonNull(ambient, "ambient");
        Objects.requireNonNull(emitted, "emitted");
        Objects.requireNonNull(refraction, "refraction");
        Objects.requireNonNull(split, "split");
        Objects.requireNonNull(facet, "facet");
        Objects.requireNonNull(reflected, "reflected");
        Objects.requireNonNull(refracted, "refracted");
        readings = List.copyOf(readings);
        lights = List.copyOf(lights);
    }

    /**
     * What a pattern has at the point.
     *
     * @param of what goes by it: {@code color}, the name of a share as in a file, {@code bump} or {@code normal-map}
     * @param pattern its kind, as in a file
     * @param point of a picture, where it was read
     * @param found light of a colour; else numbers, of which a share or a height is the luminance, or a channel
     */
    public record Reading(String of, String pattern, Optional<PicturePoint> point, LinearRgb found) {
        public Reading {
            Objects.requireNonNull(of, "of");
            Objects.requireNonNull(pattern, "pattern");
            Objects.requireNonNull(point, "point");
            Objects.requireNonNull(found, "found");
        }
    }

    /**
     * Where a picture was read.
     *
     * @param u to the right, 0–1 within the picture, which repeats beyond
     * @param v upwards, likewise
     * @param column of the nearest of its points
     * @param row of that, from the top
     * @param value what the picture has there: light of a colour, else numbers
     */
    public record PicturePoint(String file, double u, double v, int column, int row, LinearRgb value) {
        public PicturePoint {
            Objects.requireNonNull(file, "file");
            Objects.requireNonNull(value, "value");
        }
    }

    /** What adds up to the ray's light, in the order in which it is added. */
    public List<LinearRgb> terms() {
        List<LinearRgb> terms = new ArrayList<>();
        terms.add(ambient);
        if (!emitted.equals(LinearRgb.BLACK)) {
            terms.add(emitted);
        }
        lights.forEach(term -> terms.add(term.added()));
        reflected.ifPresent(ray -> terms.add(ray.light().times(ray.weight())));
        refracted.ifPresent(ray -> terms.add(ray.light().times(ray.weight())));
        return terms;
    }

    /**
     * Where in a triangle of a mesh, or of relief.
     *
     * @param number of the triangle, from 0, in the order of the file; of relief there are two in each square of four points, row by row from −z on
     * @param part the name of the file's part that it belongs to; empty if that has none
     * @param shares how much of each of its three corners is in the point, 0–1, together 1
     */
    public record Triangle(int number, String part, Vec3 shares) {
        public Triangle {
            Objects.requireNonNull(part, "part");
            Objects.requireNonNull(shares, "shares");
        }
    }

    /**
     * Where a ray has hit a surface.
     *
     * @param surface whose: an object's, or within an operation that of a primitive
     * @param face which of its faces
     * @param triangle which triangle of a mesh or of relief; empty for what is not made of triangles
     * @param flipped whether a difference turned the surface inside out: it is the wall of a hole
     * @param fromInside whether the ray comes from inside the body, or on the −z side of a flat figure
     * @param distance from the ray's origin
     * @param point world space
     * @param normal of length 1, out of the body
     * @param towardsViewer the normal that light is reckoned with, on the side the ray comes from
     * @param u where in a picture that covers the surface, 0–1 to the right; beyond on a surface without end
     * @param v likewise, upwards
     * @param cosine of the angle between the ray and the normal, 0–1
     * @param mirrored R, the mirrored direction, of length 1
     */
    public record Place(
            InScene<BodyAt> surface,
            Shape.Face face,
            Optional<Triangle> triangle,
            boolean flipped,
            boolean fromInside,
            double distance,
            Vec3 point,
            Vec3 normal,
            Vec3 towardsViewer,
            double u,
            double v,
            double cosine,
            Vec3 mirrored) {
        public Place {
            Objects.requireNonNull(surface, "surface");
            Objects.requireNonNull(face, "face");
            Objects.requireNonNull(triangle, "triangle");
            Objects.requireNonNull(point, "point");
            Objects.requireNonNull(normal, "normal");
            Objects.requireNonNull(towardsViewer, "towardsViewer");
            Objects.requireNonNull(mirrored, "mirrored");
        }


        /** The angle between the ray and the normal, 0–90. */
        public double angleDegrees() {
            return Math.toDegrees(StrictMath.acos(Math.min(1, cosine)));
        }
    }

    /**
     * A ray comes to a transparent surface.
     *
     * @param from n₁, refractive index before it
     * @param to n₂, refractive index beyond it
     * @param cosine of the angle θ₁ between the ray and the normal
     * @param radicand cos² θ₂ = 1 + (n₁/n₂)²(cos² θ₁ − 1); below 0 there is no angle θ₂, and all light is reflected
     */
    public record Refraction(double from, double to, double cosine, double radicand) {
        /** Whether all light is reflected. */
        public boolean isTotal() {
            return radicand < 0;
        }

        /** θ₁, 0–90. */
        public double angleBeforeDegrees() {
            return Math.toDegrees(StrictMath.acos(Math.min(1, cosine)));
        }

        /** θ₂, 0–90; not a number if all light is reflected. */
        public double angleBeyondDegrees() {
            return Math.toDegrees(StrictMath.acos(Math.min(1, Math.sqrt(radicand))));
        }

        /** The angle from which on all light is reflected; not a number if n₁ ≤ n₂. */
        public double criticalAngleDegrees() {
            return from > to ? Math.toDegrees(StrictMath.asin(to / from)) : Double.NaN;
        }
    }

    /**
     * A facet of a rough surface, among those that are seen; one ray stands for what is mirrored and what is let through.
     *
     * @param normal m, of length 1
     * @param chance with which it was decided between the two: the ray's weight is divided by it
     * @param seen G₁, the share of facets that are seen from where the ray goes
     */
    public record Facet(Vec3 normal, double chance, double seen) {
        public Facet {
            Objects.requireNonNull(normal, "normal");
        }
    }

    /**
     * How much a surface mirrors at an angle.
     *
     * @param from n₁, refractive index before it
     * @param to n₂, refractive index beyond it
     * @param cosine cos θ₁, of the angle between the ray and the normal
     * @param beyond cos θ₂; 0 if there is no such angle
     * @param mirrored F, of what the material mirrors; of metals it has a colour
     */
    public record Split(double from, double to, double cosine, double beyond, LinearRgb mirrored) {
        public Split {
            Objects.requireNonNull(mirrored, "mirrored");
        }
    }
}
