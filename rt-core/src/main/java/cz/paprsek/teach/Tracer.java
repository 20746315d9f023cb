package cz.paprsek.teach;

import static cz.paprsek.teach.mistake.Mistake.ACNE;
import static cz.paprsek.teach.mistake.Mistake.AMBIENT_PER_LIGHT;
import static cz.paprsek.teach.mistake.Mistake.AMBIENT_UNCOLORED;
import static cz.paprsek.teach.mistake.Mistake.DEPTH_LESS;
import static cz.paprsek.teach.mistake.Mistake.DEPTH_MORE;
import static cz.paprsek.teach.mistake.Mistake.DIFFUSE_NOT_CLAMPED;
import static cz.paprsek.teach.mistake.Mistake.FIRST_LIGHT_ONLY;
import static cz.paprsek.teach.mistake.Mistake.GLASS_SHADOW_BLACK;
import static cz.paprsek.teach.mistake.Mistake.HALF_VECTOR;
import static cz.paprsek.teach.mistake.Mistake.HIGHLIGHT_BEHIND;
import static cz.paprsek.teach.mistake.Mistake.HIGHLIGHT_COLORED;
import static cz.paprsek.teach.mistake.Mistake.HIGHLIGHT_NOT_CLAMPED;
import static cz.paprsek.teach.mistake.Mistake.HIGHLIGHT_OPPOSITE;
import static cz.paprsek.teach.mistake.Mistake.L_NOT_UNIT;
import static cz.paprsek.teach.mistake.Mistake.MIRROR_BLENDS;
import static cz.paprsek.teach.mistake.Mistake.MIRROR_SIGN;
import static cz.paprsek.teach.mistake.Mistake.MISS_IS_BLACK;
import static cz.paprsek.teach.mistake.Mistake.NORMAL_NOT_TURNED;
import static cz.paprsek.teach.mistake.Mistake.NO_AMBIENT;
import static cz.paprsek.teach.mistake.Mistake.NO_COSINE;
import static cz.paprsek.teach.mistake.Mistake.NO_DIFFUSE;
import static cz.paprsek.teach.mistake.Mistake.NO_EXPONENT;
import static cz.paprsek.teach.mistake.Mistake.NO_HIGHLIGHT;
import static cz.paprsek.teach.mistake.Mistake.NO_REFLECTION;
import static cz.paprsek.teach.mistake.Mistake.NO_REFRACTION;
import static cz.paprsek.teach.mistake.Mistake.NO_SHADOW;
import static cz.paprsek.teach.mistake.Mistake.NO_TRANSPARENCY;
import static cz.paprsek.teach.mistake.Mistake.SHADOW_BEYOND_LIGHT;
import static cz.paprsek.teach.mistake.Mistake.SNELL_ALWAYS_IN;
import static cz.paprsek.teach.mistake.Mistake.SNELL_NOT_SQUARED;
import static cz.paprsek.teach.mistake.Mistake.SNELL_UPSIDE_DOWN;
import static cz.paprsek.teach.mistake.Mistake.TOTAL_REFLECTION_LOST;

import cz.paprsek.material.Material;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.Bodies.Met;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.List;
import java.util.Optional;

/**
 * Follows rays as Whitted has it:
 *
 * <pre>B = ambient·C + Σ lights V·I·( kD·C·max(0, N·L) + kS·max(0, R·L)ⁿ ) + kR·trace(R) + kT·trace(T)</pre>
 *
 * @source Whitted, An Improved Illumination Model for Shaded Display, CACM 23(6), 1980
 */
final class Tracer {
    /** The one number whose name is a word, and not a letter of the formula: the direction that the ray goes. */
    static final String RAY = "ray";

    private final Mistakes made;
    private final Notes notes;
    private final Eye eye;
    private final Bodies bodies;
    private final List<Lamp> lamps;
    private final int raysAlongASide;
    private final int maxDepth;
    private final Vec background;
    private final Vec ambient;

    Tracer(Scene scene, RenderSettings settings, Mistakes made, Notes notes) {
        this.made = made;
        this.notes = notes;
        this.eye = new Eye(scene.camera(), settings.width(), settings.height(), made, notes);
        this.bodies = new Bodies(Placing.bodies(scene, made), made);
        this.lamps = lamps(scene.lights(), made);
        this.raysAlongASide = settings.samples();
        this.maxDepth = settings.maxDepth() + (made.has(DEPTH_MORE) ? 1 : 0) - (made.has(DEPTH_LESS) ? 1 : 0);
        this.background = Paint.light(scene.background(), made);
        this.ambient = made.has(NO_AMBIENT) ? Vec.ZERO : Paint.light(scene.ambient(), made);
    }

    private static List<Lamp> lamps(List<Light> lights, Mistakes made) {
        List<Lamp> lamps = lights.stream().filter(light -> light.intensity() > 0).map(light -> new Lamp(light, made)).toList();
        return made.has(FIRST_LIGHT_ONLY) && !lamps.isEmpty() ? lamps.subList(0, 1) : lamps;
    }

    /** The light of a pixel: the mean of a grid of rays. Less than that if it takes more rays than are allowed. */
    Vec pixel(int column, int row, Allowance allowed) {
        int n = raysAlongASide;
        Vec sum = Vec.ZERO;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                sum = sum.plus(trace(eye.ray(column + (j + 0.5) / n, row + (i + 0.5) / n), 1, Media.NONE, allowed));
            }
        }
        return sum.times(1.0 / (n * n));
    }

    /** The light that a ray brings. */
    private Vec trace(Ray ray, int depth, Media media, Allowance allowed) {
        if (depth > maxDepth || !allowed.take()) {
            return Vec.ZERO;
        }
        Optional<Met> met = bodies.first(ray, media);
        if (met.isEmpty()) {
            return depth > 1 && made.has(MISS_IS_BLACK) ? Vec.ZERO : background;
        }
        Hit hit = hit(ray, media, met.get());
        Vec local = shade(hit, depth);
        Material material = hit.paint().material;
        if (depth == maxDepth || (material.reflection() == 0 && material.transparency() == 0)) {
            return local;
        }
        return follow(hit, material, made.has(MIRROR_BLENDS) ? local.times(1 - material.reflection()) : local, depth, allowed);
    }

    private Hit hit(Ray ray, Media media, Met met) {
        Vec point = ray.at(met.t());
        Vec normal = met.crossing().normal(point);
        boolean leaving = ray.direction().dot(normal) > 0;
        Vec turned = leaving && !made.has(NORMAL_NOT_TURNED) ? normal.times(-1) : normal;
        return new Hit(ray, media, met, point, Math.abs(met.t()) + point.size(), turned, leaving);
    }

    /** Ambient light, and what comes straight from the lights. */
    private Vec shade(Hit hit, int depth) {
        Material material = hit.paint().material;
        Vec n = hit.normal();
        Vec d = hit.ray().direction();
        Vec r = mirrored(d, n);
        Vec color = hit.paint().color(hit.met().crossing().of(), hit.point(), hit.size());
        Notes here = depth == 1 ? notes : Notes.NONE;
        here.put(RAY, d).put("t", hit.met().t()).put("P", hit.point()).put("N", n).put("R", r).put("C", color);
        Vec sum = made.has(AMBIENT_UNCOLORED) ? ambient : ambient.times(color);
        for (int i = 0; i < lamps.size(); i++) {
            sum = i > 0 && made.has(AMBIENT_PER_LIGHT) ? sum.plus(ambient.times(color)) : sum;
            Lamp.Seen lamp = lamps.get(i).from(hit.point());
            Vec l = made.has(L_NOT_UNIT) && lamp.distance() < Double.POSITIVE_INFINITY ? lamp.direction().times(lamp.distance()) : lamp.direction();
            double facing = n.dot(l);
            here.put("L" + (i + 1), l).put("N·L" + (i + 1), facing).put("R·L" + (i + 1), r.dot(l));
            if (!(facing > 0) && !made.has(DIFFUSE_NOT_CLAMPED) && !made.has(HIGHLIGHT_BEHIND)) {
                continue;
            }
            double visible = visibility(hit, lamp);
            double kd = facing > 0 || made.has(DIFFUSE_NOT_CLAMPED) ? diffuse(material, facing) : 0;
            double ks = facing > 0 || made.has(HIGHLIGHT_BEHIND) ? highlight(material, d, n, r, l) : 0;
            here.put("V" + (i + 1), visible).put("kD·N·L" + (i + 1), kd).put("kS·(R·L)ⁿ" + (i + 1), ks);
            Vec shine = made.has(HIGHLIGHT_COLORED) ? color.times(ks) : new Vec(ks, ks, ks);
            sum = visible > 0 ? sum.plus(lamp.light().times(visible).times(color.times(kd).plus(shine))) : sum;
        }
        return sum;
    }

    private double diffuse(Material material, double facing) {
        return made.has(NO_DIFFUSE) ? 0 : made.has(NO_COSINE) ? material.diffusion() : material.diffusion() * facing;
    }

    /** kS·max(0, cos)ⁿ; whole exponents are multiplied out, by squaring. */
    private double highlight(Material material, Vec d, Vec n, Vec r, Vec l) {
        double cosine = made.has(HALF_VECTOR) ? n.dot(l.minus(d).unit()) : made.has(HIGHLIGHT_OPPOSITE) ? -r.dot(l) : r.dot(l);
        if (made.has(NO_HIGHLIGHT) || material.specular() == 0 || !(cosine > 0 || made.has(HIGHLIGHT_NOT_CLAMPED))) {
            return 0;
        }
        double exponent = made.has(NO_EXPONENT) ? 1 : material.shininess();
        if (exponent != Math.rint(exponent)) {
            return material.specular() * StrictMath.pow(cosine, exponent);
        }
        double result = material.specular();
        double factor = cosine;
        for (int k = (int) exponent; k > 0; k >>= 1) {
            result = (k & 1) != 0 ? result * factor : result;
            factor *= factor;
        }
        return result;
    }

    /** The share of light that arrives: the product of what all surfaces on the way let through. */
    private double visibility(Hit hit, Lamp.Seen lamp) {
        if (made.has(NO_SHADOW)) {
            return 1;
        }
        double end = made.has(SHADOW_BEYOND_LIGHT) ? Double.POSITIVE_INFINITY : lamp.distance() - Ray.TOUCH * hit.size();
        Ray ray = made.has(ACNE) ? Ray.fromEye(hit.point(), lamp.direction()) : hit.back(lamp.direction());
        List<Crossing> between = bodies.between(ray, hit.media(), end);
        // In one order, whatever that of the bodies: the last bit of a product depends on it.
        return between.isEmpty() ? 1 : between.stream().map(crossing -> made.has(GLASS_SHADOW_BLACK) ? 0 : crossing.of().paint.material.transparency())
                .sorted().reduce(1.0, (product, share) -> product * share);
    }

    /** R = d + 2·c·N, with c = |d·N|. */
    private Vec mirrored(Vec d, Vec n) {
        double c = made.has(NORMAL_NOT_TURNED) ? -d.dot(n) : Math.abs(d.dot(n));
        return made.has(MIRROR_SIGN) ? d.minus(n.times(2 * c)) : d.plus(n.times(2 * c));
    }

    /**
     * Adds what is mirrored and what shines through. With e = n₁/n₂ and t = 1 + e²(c² − 1), the refracted direction is e·d + (e·c − √t)·N; if t is
     * negative all light is mirrored.
     */
    private Vec follow(Hit hit, Material material, Vec light, int depth, Allowance allowed) {
        Vec d = hit.ray().direction();
        Vec n = hit.normal();
        double reflection = material.reflection();
        boolean refracts = material.transparency() > 0;
        Media media = hit.media();
        Media beyond = hit.beyond(material.refractiveIndex());
        double e = made.has(SNELL_UPSIDE_DOWN) ? beyond.index() / media.index()
                : made.has(SNELL_ALWAYS_IN) ? 1 / material.refractiveIndex() : made.has(NO_REFRACTION) ? 1 : media.index() / beyond.index();
        double c = Math.abs(d.dot(n));
        double t = 1 + (made.has(SNELL_NOT_SQUARED) ? e : e * e) * (c * c - 1);
        if (refracts && t < 0) {
            refracts = false;
            reflection += made.has(TOTAL_REFLECTION_LOST) ? 0 : material.transparency();
        }
        Vec sum = light;
        if (reflection > 0 && !made.has(NO_REFLECTION)) {
            sum = sum.plus(trace(made.has(ACNE) ? Ray.fromEye(hit.point(), mirrored(d, n)) : hit.back(mirrored(d, n)), depth + 1, media, allowed).times(reflection));
        }
        if (refracts && !made.has(NO_TRANSPARENCY)) {
            Vec through = d.times(e).plus(n.times(e * c - Math.sqrt(t)));
            sum = sum.plus(trace(made.has(ACNE) ? Ray.fromEye(hit.point(), through) : hit.on(through), depth + 1, beyond, allowed).times(material.transparency()));
        }
        return sum;
    }

    /**
     * What a ray meets first.
     *
     * @param media around the ray
     * @param size what the rounding errors of the point are relative to
     * @param normal of length 1, turned to the viewer
     * @param leaving whether the ray comes from inside
     */
    record Hit(Ray ray, Media media, Met met, Vec point, double size, Vec normal, boolean leaving) {
        Paint paint() {
            return met.crossing().of().paint;
        }

        /** The media beyond the surface. A flat figure has no inside. */
        Media beyond(double index) {
            Media here = met.t() > ray.contact() || !ray.beyond() ? media.elsewhere() : media;
            return !met.body().isSolid ? here : leaving ? here.leaving(met.body()) : here.entering(met.body(), index);
        }

        /** A ray on the side from which the surface was seen: into the inside of the primitive if that is where it was seen from. */
        Ray back(Vec direction) {
            boolean isAlone = met.t() > ray.contact();
            return new Ray(point, direction, size, isAlone ? Ray.TOUCH * size : -Ray.TOUCH * size, met, leaving != met.crossing().flipped(), false);
        }

        /** A ray beyond the surface. */
        Ray on(Vec direction) {
            return new Ray(point, direction, size, -Ray.TOUCH * size, met, leaving == met.crossing().flipped(), true);
        }
    }

    /** How many rays a pixel may take: where each makes two, a few levels more are thousands. */
    static final class Allowance {
        private int left;

        Allowance(int rays) {
            left = rays;
        }

        static Allowance unlimited() {
            return new Allowance(Integer.MAX_VALUE);
        }

        /** Takes one; false if none is left. */
        boolean take() {
            left -= left >= 0 ? 1 : 0;
            return left >= 0;
        }

        /** Whether more were asked for than there were. */
        boolean isExceeded() {
            return left < 0;
        }
    }
}
