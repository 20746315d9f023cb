package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.image.Layers;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.math.Vec3;
import cz.paprsek.text.Numbers;
import cz.paprsek.text.Similar;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.Option;

/** How bright the lights of a finished picture are to be, of which it has a layer each. */
public final class MixWishes {
    private static final int CHANNELS = 3;

    @Option(names = "--mix", paramLabel = "LIGHT=SHARE", description =
            "How much of a light there is to be, in an exr that 'render --aov light' has written: 0 for none, 1 for as it is, 2 for a stop more, "
                    + "or three numbers such as 1,0.8,0.5 for red, green and blue; 'rest' is sky, background and what glows. Nothing is rendered again. May be given several times, once for each light.")
    private List<String> wishes = new ArrayList<>();

    /** Whether something is wished for. */
    public boolean areSaid() {
        return !wishes.isEmpty();
    }

    /**
     * A picture that has been read.
     *
     * @param layers what of its layers still holds, if lights were mixed
     * @param dropped what does not, by their names
     * @param written how it was exposed and toned, which mixed light is not yet, and where it comes from
     * @param told how its lights were mixed
     */
    public record Mixed(Image image, Layers layers, List<String> dropped, ImageOptions written, String told) {
        private static final String AFTERWARDS = "; lights mixed afterwards: ";

        private static Mixed as(Image image) {
            return new Mixed(image, Layers.ofSize(image.width(), image.height()), List.of(), ImageOptions.DEFAULT, "");
        }

        /** Tells in the new file what was done, and how the picture in it is exposed and toned. */
        public ImageOptions toldIn(ImageOptions how) {
            if (told.isEmpty()) {
                return how;
            }
            Origin origin = written.origin();
            String settings = origin.settings();
            int end = settings.indexOf(AFTERWARDS) < 0 ? settings.length() : settings.indexOf(AFTERWARDS);
            String shown = (how.exposure() == 0 ? "" : " --exposure " + Numbers.text(how.exposure())) + (how.tone() == Tone.NONE ? "" : " --tone " + how.tone());
            return how.withOrigin(new Origin(origin.scene(), origin.digest(), origin.program(), settings.substring(0, end) + shown + settings.substring(end) + AFTERWARDS + told));
        }
    }

    /**
     * A picture with its lights as they are wished for.
     *
     * @throws WrongUsage if it has no layers of lights, or not of those that are named, or what is wished for is no share, or is wished for twice
     * @throws IOException if it cannot be read
     */
    public Mixed read(Path picture) throws IOException {
        Map<String, Vec3> wanted = new LinkedHashMap<>();
        wishes.forEach(wish -> note(wish, wanted));
        if (wanted.isEmpty()) {
            return Mixed.as(ImageFiles.read(picture));
        }
        Layers layers = ImageFiles.findLayers(picture).orElseGet(() -> Layers.ofSize(1, 1));
        List<String> lights = layers.lights();
        if (lights.isEmpty() || !layers.names().contains("R")) {
            throw new WrongUsage(picture + " has no layers of lights that could be mixed; paprsek render --aov light -o FILE.exr makes them");
        }
        for (String light : wanted.keySet()) {
            if (!lights.contains(light)) {
                throw new WrongUsage(picture + " has no layer of a light '" + light + "', but of " + String.join(", ", lights) + Similar.suggestion(light, lights));
            }
        }
        try {
            layers.image("");
        } catch (IllegalArgumentException incomplete) {
            throw new IOException(picture + ": " + incomplete.getMessage(), incomplete);
        }
        Layers kept = layers.ofMix(wanted);
        List<String> dropped = layers.names().stream().filter(name -> name.length() > 1 && !kept.names().contains(name))
                .map(name -> name.substring(0, Math.max(name.lastIndexOf('.'), 1))).distinct().toList();
        String told = wanted.entrySet().stream().map(entry -> entry.getKey() + " × " + Numbers.text(entry.getValue())).collect(Collectors.joining(", "));
        return new Mixed(layers.mixed(wanted), kept, dropped, layers.written(), told);
    }

    private static void note(String wish, Map<String, Vec3> wanted) {
        int end = wish.indexOf('=');
        if (end < 0) {
            throw new WrongUsage("--mix: expected LIGHT=SHARE such as sun=0.5, but found '" + wish + "'");
        }
        String light = wish.substring(0, end);
        if (wanted.put(light, share(light, wish.substring(end + 1))) != null) {
            throw new WrongUsage("--mix " + light + " is given twice, and it is not told which is meant");
        }
    }

    private static Vec3 share(String light, String text) {
        List<OptionalDouble> numbers = Stream.of(text.split(",", -1)).map(String::strip).map(Numbers::parsed).toList();
        if (numbers.size() == 1 || numbers.size() == CHANNELS) {
            double red = numbers.get(0).orElse(-1);
            double green = numbers.get(numbers.size() / 2).orElse(-1);
            double blue = numbers.get(numbers.size() - 1).orElse(-1);
            if (Math.min(red, Math.min(green, blue)) >= 0 && Math.max(red, Math.max(green, blue)) <= Float.MAX_VALUE) {
                return new Vec3(red, green, blue);
            }
        }
        throw new WrongUsage("--mix " + light + ": expected a share from 0 such as 0.5, or three such as 1,0.8,0.5 for red, green and blue, but found '" + text + "'");
    }
}
