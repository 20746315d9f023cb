package cz.paprsek.image;

import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import java.util.List;
import java.util.Map;

/**
 * A picture whose lights are made brighter, darker or of another colour afterwards, without rendering it again: light adds up, so what each of them brings is taken as often as is
 * wished.
 */
final class LightMix {
    private static final String PREFIX = "light.";
    private static final List<String> CHANNELS = List.of(".R", ".G", ".B");
    private static final Vec3 WHOLE = new Vec3(1, 1, 1);
    /** What has nothing to do with light. */
    private static final List<String> UNLIT = List.of("normal.", "albedo.", "depth.", "object.", "samples.");

    private LightMix() {}

    static List<String> lights(Layers layers) {
        return layers.names().stream().filter(name -> name.length() > PREFIX.length() + 2 && name.startsWith(PREFIX) && name.endsWith(CHANNELS.get(0))).map(name -> name.substring(PREFIX.length(), name.length() - 2))
                .filter(word -> CHANNELS.stream().allMatch(channel -> layers.names().contains(PREFIX + word + channel))).toList();
    }

    static Image of(Image picture, Layers layers, Map<String, Vec3> shares) {
        Require.that(picture.width() == layers.width() && picture.height() == layers.height(), "a picture of " + picture.width() + " × " + picture.height()
                + " pixels has no layers of " + layers.width() + " × " + layers.height());
        float[] light = picture.toLinear();
        double[] mixed = new double[light.length];
        for (int i = 0; i < light.length; i++) {
            mixed[i] = light[i];
        }
        shares.forEach((word, share) -> {
            for (int channel = 0; channel < CHANNELS.size(); channel++) {
                add(layers.plane(PREFIX + word + CHANNELS.get(channel)), times(word, share, channel) - 1, mixed, channel);
            }
        });
        return image(picture, light, mixed);
    }

    private static double times(String word, Vec3 share, int channel) {
        return Require.within("share of light " + word, channel == 0 ? share.x() : channel == 1 ? share.y() : share.z(), 0, Float.MAX_VALUE);
    }

    /** What all lights bring together. */
    static Image sum(Layers layers) {
        double[] all = new double[CHANNELS.size() * layers.width() * layers.height()];
        for (String word : lights(layers)) {
            for (int channel = 0; channel < CHANNELS.size(); channel++) {
                add(layers.plane(PREFIX + word + CHANNELS.get(channel)), 1, all, channel);
            }
        }
        Image black = new Image(layers.width(), layers.height());
        return image(black, black.toLinear(), all);
    }

    static Layers layers(Layers layers, Map<String, Vec3> shares) {
        boolean isSame = shares.values().stream().allMatch(WHOLE::equals);
        Layers kept = Layers.ofSize(layers.width(), layers.height());
        for (String name : layers.names()) {
            int dot = name.lastIndexOf('.');
            String word = name.startsWith(PREFIX) && dot > PREFIX.length() ? name.substring(PREFIX.length(), dot) : "";
            int channel = dot < 0 ? -1 : CHANNELS.indexOf(name.substring(dot));
            if (shares.containsKey(word) && channel >= 0) {
                kept = kept.withOwn(name, scaled(layers.plane(name), times(word, shares.get(word), channel)));
            } else if (name.length() > 1 && (isSame || !word.isEmpty() || UNLIT.stream().anyMatch(name::startsWith))) {
                kept = kept.withOwn(name, layers.plane(name));
            }
        }
        return kept;
    }

    private static float[] scaled(float[] plane, double times) {
        float[] scaled = new float[plane.length];
        for (int i = 0; i < plane.length; i++) {
            scaled[i] = (float) (times * plane[i]);
        }
        return scaled;
    }

    private static void add(float[] plane, double times, double[] mixed, int channel) {
        if (times != 0) {
            for (int i = 0; i < plane.length; i++) {
                mixed[CHANNELS.size() * i + channel] += times * plane[i];
            }
        }
    }

    /** Where all light is taken away, rounding leaves a little less than none. */
    private static Image image(Image picture, float[] light, double[] mixed) {
        int width = picture.width();
        Image image = picture.isTransparent() ? Image.ofTransparent(width, picture.height()) : new Image(width, picture.height());
        double[] pixel = new double[CHANNELS.size()];
        for (int i = 0; i < width * picture.height(); i++) {
            for (int channel = 0; channel < pixel.length; channel++) {
                int at = CHANNELS.size() * i + channel;
                pixel[channel] = Math.max(mixed[at], Math.min(0, light[at]));
            }
            if (picture.isTransparent()) {
                image.set(i % width, i / width, pixel[0], pixel[1], pixel[2], picture.alpha(i % width, i / width));
            } else {
                image.set(i % width, i / width, pixel[0], pixel[1], pixel[2]);
            }
        }
        return image;
    }
}
