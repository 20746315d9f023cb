package cz.paprsek.cli;

import cz.paprsek.cli.input.Cameras;
import cz.paprsek.cli.input.Foreign;
import cz.paprsek.cli.input.FrameChoice;
import cz.paprsek.cli.input.Incoming;
import cz.paprsek.cli.input.LightWishes;
import cz.paprsek.cli.input.MixWishes;
import cz.paprsek.cli.input.MixWishes.Mixed;
import cz.paprsek.cli.input.Originals;
import cz.paprsek.cli.input.ParameterWishes;
import cz.paprsek.cli.input.SceneReading;
import cz.paprsek.cli.output.Writing;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.format.Belongings;
import cz.paprsek.format.ForeignFormat;
import cz.paprsek.format.ForeignScene;
import cz.paprsek.format.MeshWriter;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Failures;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.mesh.Triangles;
import cz.paprsek.text.Similar;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Writes a scene, or a picture, in another form. */
@Command(
        name = "convert",
        description = {
            "Writes a scene in another form, which the ending of the new file says.",
            ".pov is for POV-Ray 3.7, which computes the same picture from it. What it cannot show exactly is told in a warning.",
            ".xml is our own, in standard order and layout, for tidying up a file written by hand; for both, pictures and meshes are put beside the new file.",
            ".obj and .stl are triangles as the file of another program has them, axes and all.",
            "A picture becomes one of another format: png, jpg, hdr, exr …, its light alone, without opacity and layers; --bits, --exposure, --tone and --uncompressed are for that, "
                    + "and --mix, which makes lights brighter, darker or of another colour afterwards; in exr the layers that still hold are then kept."
        },
        footer = {"", "Examples:", "  paprsek convert showcase.xml showcase.pov", "  paprsek convert mine.xml tidy.xml",
            "  paprsek convert thing.csg thing.xml", "  paprsek convert part.stl part.obj",
            "  paprsek convert light.exr light.png --exposure 1 --tone filmic", "  paprsek convert lights.exr evening.png --mix sun=0 --mix lamp=2,1.6,1"})
final class ConvertCommand implements Callable<Integer> {
    private static final List<String> ENDINGS = List.of("pov", "xml", "obj", "stl");

    private final Terminal terminal;
    private final Stop stop;

    @Parameters(index = "0", paramLabel = "SCENE", description = "A scene file, or one of another program, or a picture; - is standard input.")
    private Path scene;

    @Parameters(index = "1", paramLabel = "FILE", description = "The file to write; its ending is pov, xml, obj or stl, or that of a picture.")
    private Path target;

    @Option(names = "--camera", paramLabel = "CAMERA", description = Cameras.HELP)
    private Optional<String> camera;

    @Option(names = "--no-floor", description = "Leaves away the floor that files of other programs are given.")
    private boolean noFloor;

    @Option(names = "--bits", paramLabel = "N", description = "Bits per channel: 8 or 16 of png, 16 or 32 of exr. Default: the smaller number.")
    private Optional<Integer> bits;

    @Option(names = "--uncompressed", description = "Writes exr as large as it is, for programs that cannot unpack it.")
    private boolean uncompressed;

    @Mixin
    private ParameterWishes given;

    @Mixin
    private FrameChoice frame;

    @Mixin
    private LightWishes shown;

    @Mixin
    private MixWishes mix;

    @Option(names = {"-q", "--quiet"}, description = "Prints errors only, no warnings.")
    private boolean quiet;

    ConvertCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() {
        String name = target.toString();
        String ending = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        Optional<ImageFormat> format = ImageFormat.ofFile(name);
        if (Foreign.isPicture(scene)) {
            return picture(format.orElseThrow(() -> new WrongUsage(scene + " is a picture; let the new file end in one of " + ImageFormat.all())));
        }
        if (format.isPresent() && !Incoming.isOnce(scene) && Files.notExists(scene)) {
            terminal.message(scene + ": no such file");
            return ExitCode.BAD_SCENE;
        }
        if (format.isPresent()) {
            throw new WrongUsage("a scene becomes a picture where it is rendered: paprsek render " + scene + " -o " + name);
        }
        if (bits.isPresent() || uncompressed || shown.areSaid() || mix.areSaid()) {
            throw new WrongUsage("--bits, --uncompressed, --exposure, --tone and --mix are for pictures, which " + scene + " is not");
        }
        if (!ENDINGS.contains(ending)) {
            throw new WrongUsage("cannot tell what form '" + name + "' is to have: let it end in .pov, .xml, .obj or .stl"
                    + Similar.suggestion(ending, ENDINGS));
        }
        SceneReading reading = SceneReading.of(scene, given);
        reading.sentences().forEach(terminal::message);
        if (!reading.isValid()) {
            return ExitCode.BAD_SCENE;
        }
        if (reading.scenes().size() != 1) {
            throw new WrongUsage(scene + " is a database of " + reading.scenes().size() + " scenes; give a file of one");
        }
        if (!quiet) {
            reading.notes().forEach(terminal::message);
        }
        Scene read = reading.foreign().filter(foreign -> noFloor).map(foreign -> foreign.withoutFloor().scene()).orElse(reading.scenes().get(0));
        return write(reading, Cameras.through(frame.of(read), camera), ending);
    }

    private int picture(ImageFormat format) {
        Writing writing = new Writing(bits, uncompressed);
        writing.check(List.of(format));
        Mixed read;
        try {
            read = mix.read(scene);
        } catch (IOException unreadable) {
            terminal.message(Failures.sentence(unreadable));
            return ExitCode.BAD_SCENE;
        }
        try {
            Originals.spare(target, "the new file", "the picture", List.of(scene));
            // Light that is mixed is exposed and toned as the picture was, if not otherwise: its own options follow.
            ImageOptions how = read.toldIn(shown.applyTo(writing.options().withExposure(read.written().exposure()).withTone(read.written().tone())));
            boolean isLayered = format == ImageFormat.EXR && !read.layers().names().isEmpty();
            stop.write(target, () -> {
                if (isLayered) {
                    ImageFiles.write(read.image(), read.layers(), target, how);
                } else {
                    ImageFiles.write(read.image(), target, format, how);
                }
            });
            if (isLayered && !read.dropped().isEmpty() && !quiet) {
                terminal.message(scene + ": warning: " + String.join(", ", read.dropped()) + " left away, which would not be of the lights as they are mixed");
            }
            return ExitCode.DONE;
        } catch (IOException e) {
            terminal.message(Failures.sentence(target.toString(), e));
            return ExitCode.FAILED;
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(String.valueOf(refused.getMessage()));
        }
    }

    private void mesh(SceneReading reading, boolean isObj) throws IOException {
        Triangles mesh = reading.foreign().flatMap(ForeignScene::triangles).map(raw -> raw.sewn(Mesh.USUAL_WELD))
                .orElseThrow(() -> new WrongUsage("only what holds triangles and nothing else can become OBJ or STL: files such as " + ForeignFormat.meshes()));
        AtomicFile.write(target, out -> {
            if (isObj) {
                MeshWriter.obj(mesh, out);
            } else {
                MeshWriter.stl(mesh, out);
            }
        });
    }

    /** Takes along what the scene needs, and says what of it is missing. */
    private List<String> belongings(Scene content, boolean areForPov) throws IOException {
        Belongings needed = new Belongings(content, given.pictures().of(scene));
        return (areForPov ? needed.takeUnpacked(target, PovFiles::nameOf) : needed.take(target)).stream().map(missing -> missing + "; it is not taken along").toList();
    }

    private int write(SceneReading reading, Scene content, String ending) {
        List<String> warnings = new ArrayList<>();
        try {
            Originals.spare(target, "the new file", "the scene", List.of(scene));
            Originals.spare(target, "the new file", "the scene's own", given.pictures().files(scene, content.recipe().included().keySet()));
            stop.write(target, () -> {
                switch (ending) {
                    case "pov" -> {
                        warnings.addAll(belongings(content, true));
                        warnings.addAll(PovFiles.write(content, target));
                    }
                    case "xml" -> {
                        warnings.addAll(belongings(content, false));
                        SceneFiles.write(content, target);
                    }
                    default -> mesh(reading, ending.equals("obj"));
                }
            });
        } catch (IOException e) {
            terminal.message(Failures.sentence(target.toString(), e));
            return ExitCode.FAILED;
        } catch (IllegalArgumentException refused) {
            terminal.message(scene + ": " + refused.getMessage());
            return ExitCode.FAILED;
        }
        if (!quiet) {
            warnings.forEach(warning -> terminal.message(scene + ": warning: " + warning));
        }
        return ExitCode.DONE;
    }
}
