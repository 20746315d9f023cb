package cz.paprsek.render.explain;

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
