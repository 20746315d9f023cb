package cz.paprsek.image;

import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.image.exr.ExrChannel;
import cz.paprsek.image.exr.ExrReader;
import cz.paprsek.image.exr.ExrType;
import cz.paprsek.image.exr.ExrWriter;
import cz.paprsek.io.BinaryInput;
import cz.paprsek.io.PlainText;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** Pictures and layers as OpenEXR: linear light, unclamped. */
final class Exr {
    private static final int LONGEST_LIST = 200;

    private Exr() {}

    /** @param bits 16 or 32 per channel */
    static void write(Image image, int bits, Origin origin, OutputStream out) throws IOException {
        write(image.width(), image.height(), List.of("R", "G", "B"), bits, origin, (channel, y, row) -> {
            for (int x = 0; x < row.length; x++) {
                row[x] = switch (channel) {
                    case "R" -> image.red(x, y);
                    case "G" -> image.green(x, y);
                    default -> image.blue(x, y);
                };
            }
        }, out);
    }

    /** @param bits 16 or 32 per channel */
    static void write(Layers layers, int bits, Origin origin, OutputStream out) throws IOException {
        write(layers.width(), layers.height(), layers.names(), bits, origin, layers::copy, out);
    }

    private static void write(int width, int height, List<String> names, int bits, Origin origin, ExrWriter.Rows rows, OutputStream out) throws IOException {
        List<ExrChannel> channels = names.stream().map(name -> new ExrChannel(name, bits == 16 ? ExrType.HALF : ExrType.FLOAT)).toList();
        ExrWriter.write(width, height, channels, true, texts(origin), rows, out);
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
        return layers;
    }
}
