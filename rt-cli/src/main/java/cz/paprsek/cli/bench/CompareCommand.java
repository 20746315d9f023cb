package cz.paprsek.cli.bench;

import cz.paprsek.cli.input.Foreign;
import cz.paprsek.cli.input.Originals;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.Share;
import cz.paprsek.image.ImageComparison;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.StoredImage;
import cz.paprsek.io.Failures;
import cz.paprsek.io.Json;
import cz.paprsek.text.Numbers;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Says how far two pictures are apart. */
@Command(
        name = "compare",
        description = {
            "Says how far two pictures of one size are apart, and by the exit code whether they are the same: 0 if so, 1 if not.",
            "Any two kinds can be compared: PNG, PPM and PGM of 8 or 16 bits, PFM, OpenEXR, Radiance, JPEG, BMP, TIFF, and text of "
                    + "brightness. They are compared in steps of the coarser one: 1/255 of sRGB if one has 8 bits, 1/2048 of a channel if one has "
                    + "half floats, else 1/65535 of linear light; in brightness "
                    + "alone if one has no colours."
        },
        footer = {
            "",
            "Examples:",
            "  paprsek compare before.png after.png --heatmap difference.png",
            "  paprsek compare ours.pfm povray.png --tolerance 2 --at-most 0.1%%"
        })
public final class CompareCommand implements Callable<Integer> {
    private final Terminal terminal;
    private final Stop stop;

    @Parameters(index = "0", paramLabel = "A", description = "A picture.")
    private Path first;

    @Parameters(index = "1", paramLabel = "B", description = "Another one.")
    private Path second;

    @Option(names = "--tolerance", paramLabel = "STEPS", description =
            "By how many steps a channel may differ. Default: what rounding explains, 1 of 8 bits or 2 of 16.")
    private Optional<Double> tolerance;

    @Option(names = "--at-most", paramLabel = "SHARE", defaultValue = "0", description =
            "Which share of pixels may differ by more, as 0.001 or 0.1%%. Default: none.")
    private Share atMost;

    @Option(names = "--heatmap", paramLabel = "FILE", description =
            "Writes a picture of the differences: black for none, blue within the tolerance, red to white the farther beyond.")
    private Optional<Path> heatmap;

    @Option(names = "--json", description = "Prints a JSON object instead of plain text.")
    private boolean json;

    @Option(names = {"-q", "--quiet"}, description = "Prints errors only, and what --json asks for.")
    private boolean quiet;

    public CompareCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() {
        tolerance.ifPresent(steps -> require(steps >= 0, "--tolerance must be 0 or above, but is " + Numbers.text(steps)));
        heatmap.ifPresent(map -> Originals.spare(map, "the heat map", "the picture", List.of(first, second)));
        Optional<StoredImage> a = read(first);
        Optional<StoredImage> b = read(second);
        if (a.isEmpty() || b.isEmpty()) {
            return ExitCode.BAD_SCENE;
        }
        double allowed = tolerance.orElse(ImageComparison.Unit.of(a.get(), b.get()).usualTolerance());
        try {
            ImageComparison comparison = ImageComparison.of(a.get(), b.get(), allowed);
            boolean isSame = comparison.shareBeyond() <= atMost.value();
            report(comparison, isSame);
            return drawn(a.get(), b.get(), allowed) ? isSame ? ExitCode.DONE : ExitCode.FAILED : ExitCode.FAILED;
        } catch (IllegalArgumentException sizes) {
            terminal.message(first + ", " + second + ": " + sizes.getMessage());
            return ExitCode.FAILED;
        }
    }

    private static void require(boolean condition, String sentence) {
        if (!condition) {
            throw new WrongUsage(sentence);
        }
    }

    private Optional<StoredImage> read(Path file) {
        try {
            return Optional.of(ImageFiles.readStored(file));
        } catch (IOException e) {
            terminal.message(Failures.sentence(file.toString(), e) + Foreign.sceneInPlaceOfPicture(file));
            return Optional.empty();
        }
    }

    private boolean drawn(StoredImage a, StoredImage b, double allowed) {
        if (heatmap.isPresent()) {
            ImageFormat format = ImageFormat.ofFile(heatmap.get().toString()).orElse(ImageFormat.PNG);
            try {
                stop.write(heatmap.get(), () -> ImageFiles.write(ImageComparison.heatmap(a, b, allowed), heatmap.get(), format));
            } catch (IOException e) {
                terminal.message(Failures.sentence(heatmap.get().toString(), e));
                return false;
            }
        }
        return true;
    }

    private void report(ImageComparison found, boolean isSame) {
        if (json) {
            terminal.result(new Json().with("a", first.toString()).with("b", second.toString()).with("same", isSame)
                    .with("unit", found.unit().description()).with("grey", found.isGrey()).with("tolerance", found.tolerance())
                    .with("largest", found.largest()).with("x", found.x()).with("y", found.y())
                    .with("mean", found.mean()).with("rmse", found.rootMeanSquare())
                    .with("beyond", found.beyond()).with("pixels", found.pixels()).with("share", found.shareBeyond()).toString());
        } else if (!quiet) {
            terminal.result((isSame ? "the same" : "different") + (found.isGrey() ? " in brightness" : "") + ", in steps of "
                    + found.unit().description() + ":");
            terminal.result("  largest           " + steps(found.largest())
                    + (found.largest() > 0 ? " at column " + found.x() + ", row " + found.y() : ""));
            terminal.result("  mean              " + steps(found.mean()));
            terminal.result("  root mean square  " + steps(found.rootMeanSquare()));
            terminal.result("  beyond " + Numbers.text(found.tolerance()) + "          " + found.beyond() + " of " + found.pixels() + " pixels, "
                    + String.format(Locale.ROOT, "%.3f %%", 100 * found.shareBeyond()));
        }
    }

    /** A number of steps with three decimals at most. */
    static String steps(double value) {
        return Double.isFinite(value) ? Numbers.text(Math.rint(value * 1000) / 1000) : "not a number";
    }
}
