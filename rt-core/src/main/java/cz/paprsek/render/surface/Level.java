package cz.paprsek.render.surface;

import cz.paprsek.ray.Hit;
import cz.paprsek.shape.copied.CopiedPart;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import org.jspecify.annotations.Nullable;

/** Scratch of one level of recursion: a ray, what it met, and the light it brings back. */
public final class Level {
    public final Ray ray;
    public final Hit hit = new Hit();
    /** The part that is hit; kept only if some finish asks for it, as one with a picture. */
    public @Nullable Part part;
    /** Becomes the part that is hit, if that is one of a copy. */
    public final CopiedPart copied = new CopiedPart();
    /** For places beside the hit. */
    final Hit probe = new Hit();
    /** How a picture lies around the hit. */
    final Chart chart = new Chart();
    /** How much a height grows along x, y and z of the world. */
    final double[] slope = new double[3];
    /** What the surface is at the hit. */
    public Finish finish;
    /** What the surface is there, if that depends on the point. */
    final Finish own = new Finish();
    /** What the ray stands for; kept only if a paint asks for it. */
    public final Footprint footprint = new Footprint();
    public final Media media = new Media();
    /** Whether the ray goes on beyond the surface it starts from, rather than back to the side it was seen from. */
    public boolean beyond;
    /** Whether lights that the ray sees have been counted where it starts. */
    public boolean isLit;
    /** Whether what lights bring to the hit has been added, together with the others of a block of rays from the eye. */
    public boolean isIlluminated;
    /** Of such a ray of a path, how probable its direction was, per solid angle. */
    public double density;
    /** Of such a ray of a path, which share it brings of the light that the surface it meets gives off. */
    public double glow = 1;
    /** What the path's light is worth to its pixel so far: the largest channel. */
    public double weight = 1;
    /** How much of the light that a path's ray brings counts where it starts, by channel. */
    public double shareRed;
    public double shareGreen;
    public double shareBlue;
    /** How the ray came about, in the sampler's terms: what is random at its end depends on that, too. */
    public int path;
    /** Of a ray from the eye, whether the pixel's filter takes away what it brings. */
    public boolean isNegative;
    /** Whether the hit's normals were turned round: the ray comes from inside. */
    public boolean leaving;
    /** Whether the normal that light is reckoned with is not that of the surface itself. */
    public boolean isBent;
    /** Cosine of the angle between the ray and the normal that light is reckoned with, 0–1. */
    public double cosine;
    /** The mirrored direction, of length 1. */
    public double mirrorX;
    public double mirrorY;
    public double mirrorZ;
    /** The colour of the surface at the hit, linear. */
    public double colorRed;
    public double colorGreen;
    public double colorBlue;
    /** The light that the ray brings back, linear. */
    public double red;
    public double green;
    public double blue;

    public Level(Spans spans) {
        ray = new Ray(spans);
        finish = own;
    }

    public void light(double r, double g, double b) {
        red = r;
        green = g;
        blue = b;
    }

    public void add(double r, double g, double b) {
        red += r;
        green += g;
        blue += b;
    }

    /** Adds another level's light times a weight. */
    public void add(double weight, Level other) {
        add(weight * other.red, weight * other.green, weight * other.blue);
    }

    /** Adds another level's light times a weight for each channel. */
    public void add(double r, double g, double b, Level other) {
        add(r * other.red, g * other.green, b * other.blue);
    }
}
