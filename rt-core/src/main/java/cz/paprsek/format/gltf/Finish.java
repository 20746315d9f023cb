package cz.paprsek.format.gltf;

import cz.paprsek.image.Image;
import cz.paprsek.material.Rgb;
import java.util.stream.IntStream;

/**
 * What a surface does to light at each point: what it covers, how far it conducts, how rough it is and how much it lets through.
 *
 * <p>What conducts mirrors all in its colour; everything else scatters its colour and mirrors by Fresnel's equations, unless its roughness is above {@value #MATTE}, where that
 * is hardly seen. What is half metal is taken for a metal that mirrors by half, and scatters by half.
 *
 * @source Khronos Group, glTF 2.0 Specification, 2021, §3.9 and appendix B
 */
final class Finish {
    private static final double MATTE = 0.6;
    /** What scatters of light that is not mirrored, of an index of 1.5. */
    private static final double WITHIN = 0.96;

    private static final double[] LIGHT = IntStream.range(0, 256).mapToDouble(Rgb::linear).toArray();

    private final Channel cover;
    private final Channel metal;
    private final Channel transmission;
    private final boolean isMetal;
    private final boolean isMixed;
    private final boolean mirrors;

    Finish(Channel cover, Channel metal, Channel roughness, Channel transmission) {
        this.cover = cover;
        this.metal = metal;
        this.transmission = transmission;
        this.isMetal = metal.most() >= 0.5;
        this.isMixed = isMetal && metal.least() < 0.5;
        this.mirrors = isMetal || roughness.least() <= MATTE || transmission.most() > 0;
    }

    boolean isMetal() {
        return isMetal;
    }

    boolean mirrors() {
        return mirrors;
    }

    boolean isSeenThrough() {
        return cover.least() < 1 || transmission.most() > 0;
    }

    /** Whether its shares are the same everywhere. */
    boolean isEven() {
        return cover.isEven() && transmission.isEven() && !isMixed;
    }

    private double conducts(double share) {
        return isMixed ? share : isMetal ? 1 : 0;
    }

    private double diffusion(double covered, double conducting, double through) {
        return covered * (1 - conducts(conducting)) * (1 - through) * (mirrors && !isMetal ? WITHIN : 1);
    }

    private double reflection(double covered, double conducting) {
        return mirrors ? covered * (isMetal ? conducts(conducting) : 1) : 0;
    }

    private double transparency(double covered, double conducting, double through) {
        return 1 - covered + covered * through * (1 - conducts(conducting));
    }

    double diffusion() {
        return diffusion(cover.most(), metal.most(), transmission.most());
    }

    double reflection() {
        return reflection(cover.most(), metal.most());
    }

    double transparency() {
        return transparency(cover.most(), metal.most(), transmission.most());
    }

    /** Diffusion as red, reflection as green, transparency as blue: numbers, not light. */
    Image shares() {
        int width = Math.max(cover.width(), Math.max(transmission.width(), metal.width()));
        int height = Math.max(cover.height(), Math.max(transmission.height(), metal.height()));
        Image image = Image.ofEightBit(width, height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                double covered = cover.at(x, y, width, height);
                double conducting = metal.at(x, y, width, height);
                double through = transmission.at(x, y, width, height);
                image.set(x, y, sample(diffusion(covered, conducting, through)), sample(reflection(covered, conducting)), sample(transparency(covered, conducting, through)));
            }
        }
        return image;
    }

    /** As a grey picture. */
    static Image picture(Channel channel) {
        Image image = Image.ofEightBit(channel.width(), channel.height());
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                double light = sample(channel.at(x, y, image.width(), image.height()));
                image.set(x, y, light, light, light);
            }
        }
        return image;
    }

    /** The light that stands for a number. */
    private static double sample(double number) {
        return LIGHT[(int) Math.rint(255 * Math.max(0, Math.min(1, number)))];
    }
}
