package cz.paprsek.cli.db;

import cz.paprsek.cli.input.Incoming;
import cz.paprsek.cli.input.ParameterWishes;
import cz.paprsek.cli.input.Pictures;
import cz.paprsek.cli.process.BadScene;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.format.Belongings;
import cz.paprsek.io.Failures;
import cz.paprsek.query.Filter;
import cz.paprsek.query.FilterException;
import cz.paprsek.query.Table;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.xml.DatabaseFile;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.Problem;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Option;

/** What the commands on databases have in common: how files are read and changed, and how mistakes become sentences. */
public abstract class DbAction implements Callable<Integer> {
    final Terminal terminal;
    final Stop stop;

    @Option(names = {"-q", "--quiet"}, description = "Prints errors and results only.")
    private boolean quiet;

    DbAction(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public final Integer call() {
        try {
            run();
            return stop.requested() ? ExitCode.INTERRUPTED : ExitCode.DONE;
        } catch (BadScene e) {
            e.sentences().forEach(terminal::message);
            return ExitCode.BAD_SCENE;
        } catch (IOException e) {
            terminal.message(stop.requested() ? "interrupted, nothing is changed" : Failures.sentence(e));
            return stop.requested() ? ExitCode.INTERRUPTED : ExitCode.FAILED;
        }
    }

    /** Does what the command says. */
    abstract void run() throws IOException;

    /** Tells what was done, unless the user wants it quiet. */
    final void done(String sentence) {
        if (!quiet) {
            terminal.message(sentence);
        }
    }

    static SceneDatabase read(Path file) {
        return readable(file, () -> Incoming.read(file, ParameterWishes.NONE)).database(Incoming.nameOf(file));
    }

    /** As it is, to take scenes from it with their text. */
    static OriginalText text(Path file) {
        return readable(file, () -> Incoming.text(file, ParameterWishes.NONE));
    }

    private interface Reading<T> {
        T read() throws SceneFileException, IOException;
    }

    private static <T> T readable(Path file, Reading<T> reading) {
        try {
            return reading.read();
        } catch (SceneFileException e) {
            throw new BadScene(e.problems().stream().map(Problem::toString).toList());
        } catch (IOException e) {
            throw new BadScene(List.of(Failures.sentence(file.toString(), e)));
        }
    }

    /** What becomes of a database. */
    @FunctionalInterface
    interface Change {
        SceneDatabase apply(SceneDatabase database) throws IOException;
    }

    /**
     * Changes a database while nobody else can.
     *
     * @param from files that scenes are taken from
     */
    final void update(Path file, Change change, OriginalText... from) throws IOException {
        Incoming.requireFile(file);
        if (!Files.exists(file)) {
            throw new BadScene(List.of(file + ": no such file"));
        }
        stop.guard(() -> {
            try {
                DatabaseFile.update(file, database -> asked(() -> change.apply(database)), from);
            } catch (SceneFileException e) {
                throw new BadScene(e.problems().stream().map(Problem::toString).toList());
            } catch (UncheckedIOException e) {
                throw e.getCause();
            } catch (IOException e) {
                // Of a scene no other machine makes a database.
                if (Files.isReadable(file) && !SceneFiles.isDatabase(file)) {
                    throw new BadScene(List.of(Failures.sentence(e)));
                }
                throw e;
            }
        });
    }

    /**
     * Takes along, to the folder of the file that scenes are taken into, the pictures and meshes that they name, and tells which of these are missing.
     *
     * @throws IOException if there is another of the same name
     */
    final void takeAlong(Path from, List<Scene> scenes, Path to) throws IOException {
        for (Scene scene : scenes) {
            try {
                for (String missing : new Belongings(scene, new Pictures().of(from)).take(to)) {
                    done(to + ": warning: scene \"" + scene.name() + "\": " + missing + "; it is not taken along");
                }
            } catch (IOException e) {
                throw new IOException(Failures.sentence(to.toString(), e), e);
            }
        }
    }

    /** What the user asked for, refused if it makes no sense. */
    static <T> T asked(Callable<T> wish) {
        try {
            return wish.call();
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(String.valueOf(refused.getMessage()));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (RuntimeException e) {
            throw e;
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    public static <R> Filter<R> filter(String option, Optional<String> text, Table<R> table) {
        try {
            return Filter.parse(text.orElse(""), table);
        } catch (FilterException e) {
            throw new WrongUsage(option + ", " + e.getMessage());
        }
    }

    /** "1 scene", "2 scenes". */
    static String scenes(int number) {
        return number + (number == 1 ? " scene" : " scenes");
    }
}
