package cz.paprsek.cli;

import cz.paprsek.cli.input.Cameras;
import cz.paprsek.cli.input.SceneReading;
import cz.paprsek.cli.output.Beside;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.format.ForeignScene;
import cz.paprsek.format.MeshWriter;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Failures;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.scene.Scene;
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
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Writes a scene in another form. */
@Command(
        name = "convert",
        description = {
            "Writes a scene in another form; what form, is told by the ending of the new file:",
            ".pov is for POV-Ray 3.7, which computes the same picture from it. What it cannot show exactly is told in a warning.",
            ".xml is our own, in standard order and layout, for tidying up a file written by hand; of a file of another program, with its meshes beside it.",
            ".obj and .stl are triangles as the file of another program has them, axes and all."
        },
        footer = {"", "Examples:", "  paprsek convert showcase.xml showcase.pov", "  paprsek convert mine.xml tidy.xml",
            "  paprsek convert thing.csg thing.xml", "  paprsek convert part.stl part.obj"})
final class ConvertCommand implements Callable<Integer> {
    private static final List<String> ENDINGS = List.of("pov", "xml", "obj", "stl");

    private final Terminal terminal;
    private final Stop stop;

    @Parameters(index = "0", paramLabel = "SCENE", description = "A scene file, or one of another program; - is standard input.")
    private Path scene;

    @Parameters(index = "1", paramLabel = "FILE", description = "The file to write, ending in .pov, .xml, .obj or .stl.")
    private Path target;

    @Option(names = "--camera", paramLabel = "CAMERA", description = Cameras.HELP)
    private Optional<String> camera;

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
        if (!ENDINGS.contains(ending)) {
            throw new WrongUsage("cannot tell what form '" + name + "' is to have: let it end in .pov, .xml, .obj or .stl"
                    + Similar.suggestion(ending, ENDINGS));
        }
        SceneReading reading = SceneReading.of(scene);
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
        return write(reading, Cameras.through(reading.scenes().get(0), camera), ending);
    }

    private void mesh(SceneReading reading, boolean isObj) throws IOException {
        Triangles mesh = reading.foreign().flatMap(ForeignScene::triangles)
                .orElseThrow(() -> new WrongUsage("only what holds triangles and nothing else can become OBJ or STL: files such as STL, OBJ, PLY and glTF"));
        AtomicFile.write(target, out -> {
            if (isObj) {
                MeshWriter.obj(mesh, out);
            } else {
                MeshWriter.stl(mesh, out);
            }
        });
    }

    private int write(SceneReading reading, Scene content, String ending) {
        List<String> warnings = new ArrayList<>();
        try {
            if (Files.exists(target) && Files.exists(scene) && Files.isSameFile(scene, target)) {
                throw new WrongUsage("the new file would overwrite the scene " + scene + " itself");
            }
            stop.guard(() -> {
                switch (ending) {
                    case "pov" -> warnings.addAll(PovFiles.write(content, target));
                    case "xml" -> {
                        Beside.write(reading, target);
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
