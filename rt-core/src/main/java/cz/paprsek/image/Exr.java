package cz.paprsek.image;

import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.image.exr.ExrChannel;
import cz.paprsek.image.exr.ExrReader;
import cz.paprsek.image.exr.ExrType;
import cz.paprsek.image.exr.ExrWriter;
import cz.paprsek.io.BinaryInput;
import cz.paprsek.io.PlainText;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.math.Require;
import cz.paprsek.text.Numbers;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Pictures and layers as OpenEXR: linear light, unclamped. */
final class Exr {
    private static final int LONGEST_LIST = 200;
    private static final int LONGEST_SETTINGS = 10_000;
    /** The end of what a picture of ours tells of its settings. */
    private static final Pattern SHOWN = Pattern.compile("(?:(?:^| )--exposure (\\S+))?(?:(?:^| )--tone (\\S+))?((?: --mistake \\S+)?(?:; lights mixed afterwards: .*)?)\\z", Pattern.DOTALL);

    private Exr() {}

    static void write(Image image, ImageOptions options, OutputStream out) throws IOException {
        write(image, Layers.ofSize(image.width(), image.height()), options, out);
    }

    static void write(Image image, Layers further, ImageOptions options, OutputStream out) throws IOException {
        List<String> names = Stream.concat(own(image).stream(), further.names().stream()).toList();
        write(image.width(), image.height(), names, options, (channel, y, row) -> {
            if (channel.length() > 1) {
                further.copy(channel, y, row);
            } else {
                copy(image, channel, y, row);
            }
        }, out);
    }

    private static void copy(Image image, String channel, int y, float[] row) {
        for (int x = 0; x < row.length; x++) {
            row[x] = switch (channel) {
                case "R" -> image.red(x, y);
                case "G" -> image.green(x, y);
                case "B" -> image.blue(x, y);
                default -> image.alpha(x, y);
            };
        }
    }

    private static List<String> own(Image image) {
        return image.isTransparent() ? List.of("R", "G", "B", "A") : List.of("R", "G", "B");
    }

    /** @throws IllegalArgumentException if layers cannot stand beside a picture */
    static void check(Image image, Layers further) {
        Require.that(image.width() == further.width() && image.height() == further.height(), "layers of " + further.width() + " × " + further.height()
                + " pixels do not fit a picture of " + image.width() + " × " + image.height());
        Require.that(further.names().stream().allMatch(name -> name.length() > 1), "layers beside a picture have names of more than a letter, not " + further.names());
    }

    static void write(Layers layers, ImageOptions options, OutputStream out) throws IOException {
        write(layers.width(), layers.height(), layers.names(), options, layers::copy, out);
    }

    private static void write(int width, int height, List<String> names, ImageOptions options, ExrWriter.Rows rows, OutputStream out) throws IOException {
        int bits = options.bitsOf(ImageFormat.EXR);
        List<ExrChannel> channels = names.stream().map(name -> new ExrChannel(name, bits == 16 && isLight(name) ? ExrType.HALF : ExrType.FLOAT)).toList();
        ExrWriter.write(width, height, channels, !options.uncompressed(), texts(options.origin()), rows, out);
    }

    /** A distance or a number of an object has more digits than a half. */
    private static boolean isLight(String name) {
        return name.equals("Y") || List.of("R", "G", "B", "A").contains(name.substring(name.lastIndexOf('.') + 1));
    }

    private static Map<String, String> texts(Origin origin) {
        return origin.texts().entrySet().stream().collect(Collectors.toMap(
                entry -> entry.getKey().equals("Comment") ? "comments" : "paprsek" + entry.getKey(), Map.Entry::getValue, (a, b) -> a, TreeMap::new));
    }

    static StoredImage read(BinaryInput input) throws IOException {
        ExrReader reader = ExrReader.of(input);
        List<String> names = reader.channels().stream().map(ExrChannel::name).toList();
        boolean isGrey = !names.contains("R") && names.contains("Y");
        List<String> wanted = isGrey ? List.of("Y") : List.of("R", "G", "B");
        if (!names.containsAll(wanted)) {
            throw new IOException("the picture should have channels R, G and B, or Y, but has "
                    + PlainText.of(String.join(", ", names), LONGEST_LIST));
        }
        Image image = ReadLimits.blank(reader.width(), reader.height());
        float[][] rgb = new float[3][image.width()];
        int[] seen = {0};
        reader.read((channel, y, row) -> {
            int place = wanted.indexOf(names.get(channel));
            if (place >= 0) {
                System.arraycopy(row, 0, rgb[place], 0, row.length);
                seen[0]++;
            }
            if (seen[0] == wanted.size()) {
                seen[0] = 0;
                for (int x = 0; x < row.length; x++) {
                    image.set(x, y, rgb[0][x], rgb[isGrey ? 0 : 1][x], rgb[isGrey ? 0 : 2][x]);
                }
            }
        });
        boolean isHalf = reader.channels().stream().anyMatch(channel -> wanted.contains(channel.name()) && channel.type() == ExrType.HALF);
        return new StoredImage(image, isHalf ? Precision.HALF : Precision.FLOAT, isGrey);
    }

    static Layers readLayers(BinaryInput input) throws IOException {
        ExrReader reader = ExrReader.of(input);
        List<ExrChannel> channels = reader.channels();
        ReadLimits.check(reader.width(), reader.height(), channels.size());
        int width = (int) reader.width();
        int height = (int) reader.height();
        float[][] planes = new float[channels.size()][width * height];
        reader.read((channel, y, row) -> System.arraycopy(row, 0, planes[channel], y * width, width));
        Layers layers = Layers.ofSize(width, height);
        for (int i = 0; i < planes.length; i++) {
            layers = layers.withOwn(channels.get(i).name(), planes[i]);
        }
        return layers.writtenAs(written(reader.texts()));
    }

    /** What the file of one of our pictures tells of it: exposure and tone apart from all other settings. */
    private static ImageOptions written(Map<String, String> texts) {
        String settings = texts.getOrDefault("comments", "");
        if (settings.length() > LONGEST_SETTINGS) {
            return ImageOptions.DEFAULT;
        }
        Matcher shown = SHOWN.matcher(settings);
        if (!shown.find()) {
            throw new IllegalStateException("the end of every text is one");
        }
        double exposure = Optional.ofNullable(shown.group(1)).map(Numbers::parsed).orElseGet(OptionalDouble::empty).orElse(0);
        Optional<String> curve = Optional.ofNullable(shown.group(2));
        Tone tone = Stream.of(Tone.values()).filter(one -> curve.filter(one.toString()::equals).isPresent()).findAny().orElse(Tone.NONE);
        ImageOptions how = Math.abs(exposure) <= ImageOptions.MOST_STOPS ? ImageOptions.shown(exposure, tone) : ImageOptions.DEFAULT;
        return how.withOrigin(new Origin(texts.getOrDefault("paprsekTitle", ""), texts.getOrDefault("paprsekSource", ""), texts.getOrDefault("paprsekSoftware", ""),
                settings.substring(0, shown.start()) + shown.group(3)));
    }
}
