package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles.Contents;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.regex.Pattern;

/** The ways in which a scene file can come in. What is in it, or wrong with it, must not depend on the way, so every test of reading tries all. */
enum WayIn {
    PATH {
        @Override
        Contents read(byte[] file) throws SceneFileException, IOException {
            return SceneFiles.contents(Files.write(Places.FILE, file), ReadMonitor.NONE);
        }
    },
    STREAM {
        @Override
        Contents read(byte[] file) throws SceneFileException, IOException {
            return SceneFiles.contents(new ByteArrayInputStream(file), "x");
        }
    },
    TEXT {
        @Override
        boolean takes(byte[] file) {
            return text(file).filter(text -> OTHER_ENCODING.matcher(text).find()).isEmpty() && text(file).isPresent();
        }

        @Override
        Contents read(byte[] file) throws SceneFileException, IOException {
            String text = text(file).orElseThrow();
            return text.contains("<database") ? SceneReader.read(text, "text") : new Contents(List.of(SceneFiles.parse(text)), false);
        }
    },
    PIPE {
        @Override
        boolean takes(byte[] file) {
            return Places.PIPE.isPresent();
        }

        @Override
        Contents read(byte[] file) throws SceneFileException, IOException {
            return throughPipe(new ByteArrayInputStream(file), pipe -> SceneFiles.contents(pipe, ReadMonitor.NONE));
        }
    },
    ARCHIVE {
        @Override
        Contents read(byte[] file) throws SceneFileException, IOException {
            return SceneFiles.contents(Files.write(Places.ENTRY, file), ReadMonitor.NONE);
        }
    },
    WITH_TEXT {
        @Override
        Contents read(byte[] file) throws SceneFileException, IOException {
            OriginalText text = OriginalText.read(new ByteArrayInputStream(file), "x");
            assertThat(text.bytes()).isEqualTo(file);
            return text.contents();
        }
    },
    PIPE_WITH_TEXT {
        @Override
        boolean takes(byte[] file) {
            return PIPE.takes(file);
        }

        @Override
        Contents read(byte[] file) throws SceneFileException, IOException {
            return throughPipe(new ByteArrayInputStream(file), pipe -> OriginalText.read(pipe).contents());
        }
    },
    DATABASE_FILE {
        @Override
        Contents read(byte[] file) throws SceneFileException, IOException {
            Path path = Files.write(Places.FILE, file);
            try {
                return new Contents(DatabaseFile.open(path).database().scenes(), true);
            } catch (IOException refused) {
                assertThat(refused).hasMessageEndingWith(": this is a scene, not a database; it can be added to one");
                return SceneFiles.contents(path, ReadMonitor.NONE);
            }
        }
    };

    private static final Pattern OTHER_ENCODING = Pattern.compile("^\uFEFF?<\\?xml[^>]*encoding\\s*=\\s*['\"](?i)(?!utf-8['\"])");

    /** What came of reading: contents, or problems, each from its line on. */
    record Outcome(Optional<Contents> contents, List<String> problems) {
        Scene scene() {
            assertThat(problems).isEmpty();
            assertThat(contents.orElseThrow().scenes()).hasSize(1);
            return contents.orElseThrow().scenes().get(0);
        }
    }

    abstract Contents read(byte[] file) throws SceneFileException, IOException;

    /** The problems of what has no end, for {@link #ofStreams}. */
    List<String> problems(Supplier<InputStream> endless) throws IOException {
        try {
            switch (this) {
                case STREAM -> SceneFiles.contents(endless.get(), "x");
                case WITH_TEXT -> OriginalText.read(endless.get(), "x");
                case PIPE -> throughPipe(endless.get(), pipe -> SceneFiles.contents(pipe, ReadMonitor.NONE));
                case PIPE_WITH_TEXT -> throughPipe(endless.get(), pipe -> OriginalText.read(pipe).contents());
                default -> throw new IllegalArgumentException(this + " has a beginning and an end");
            }
            return List.of();
        } catch (SceneFileException refused) {
            return refused.problems().stream().map(p -> p.line() + ":" + p.column() + ": " + p.message()).toList();
        }
    }

    /** Those that what has no end can come in by. */
    static List<WayIn> ofStreams() {
        return Places.PIPE.isPresent() ? List.of(STREAM, WITH_TEXT, PIPE, PIPE_WITH_TEXT) : List.of(STREAM, WITH_TEXT);
    }

    /** Whether such a file can come in this way. */
    boolean takes(byte[] file) {
        return true;
    }

    /** As {@link #read}, for several threads. */
    Contents readAlone(byte[] file) throws SceneFileException, IOException {
        synchronized (WayIn.class) {
            return read(file);
        }
    }

    Outcome outcome(byte[] file) throws IOException {
        try {
            return new Outcome(Optional.of(read(file)), List.of());
        } catch (SceneFileException refused) {
            assertThat(refused.problems()).isNotEmpty();
            return new Outcome(Optional.empty(), refused.problems().stream().map(p -> p.line() + ":" + p.column() + ": " + p.message()).toList());
        }
    }

    /** What comes of reading a file, the same in all ways; not for several threads at once. */
    static synchronized Outcome all(byte[] file) throws IOException {
        Outcome first = STREAM.outcome(file);
        for (WayIn way : values()) {
            if (way.takes(file)) {
                assertThat(way.outcome(file)).as("%s: %s", way, new String(file, 0, Math.min(file.length, 2000), StandardCharsets.UTF_8)).isEqualTo(first);
            }
        }
        return first;
    }

    static Outcome all(String file) throws IOException {
        return all(file.getBytes(StandardCharsets.UTF_8));
    }

    /** How to read a path. */
    interface Reading {
        Contents of(Path file) throws SceneFileException, IOException;
    }

    private static Contents throughPipe(InputStream content, Reading reading) throws SceneFileException, IOException {
        Path pipe = Places.PIPE.orElseThrow();
        Thread writer = new Thread(() -> write(content, pipe));
        writer.start();
        try {
            return reading.of(pipe);
        } finally {
            join(writer);
        }
    }

    private static void write(InputStream content, Path pipe) {
        try (OutputStream output = Files.newOutputStream(pipe)) {
            content.transferTo(output);
        } catch (IOException hungUp) {
            // The reader had seen enough.
        }
    }

    private static void join(Thread thread) {
        try {
            thread.join();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    private static Optional<String> text(byte[] file) {
        try {
            return Optional.of(StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(file)).toString());
        } catch (CharacterCodingException binary) {
            return Optional.empty();
        }
    }

    /** Made once: a process for every pipe would take longer than all reading. */
    private static final class Places {
        static final Path FOLDER = folder();
        static final Path FILE = FOLDER.resolve("scéna.xml");
        static final Path ENTRY = archive().getPath("/scéna.xml");
        static final Optional<Path> PIPE = pipe();

        private static Path folder() {
            try {
                Path folder = Files.createTempDirectory("ways");
                Runtime.getRuntime().addShutdownHook(new Thread(() -> {
                    for (String name : List.of("scéna.xml", "a.zip", "pipe.xml", "")) {
                        folder.resolve(name).toFile().delete();
                    }
                }));
                return folder;
            } catch (IOException e) {
                throw new IllegalStateException(e);
            }
        }

        private static FileSystem archive() {
            try {
                return FileSystems.newFileSystem(URI.create("jar:" + FOLDER.resolve("a.zip").toUri()), Map.of("create", "true"));
            } catch (IOException e) {
                throw new IllegalStateException(e);
            }
        }

        /** There are none on Windows. */
        private static Optional<Path> pipe() {
            Path pipe = FOLDER.resolve("pipe.xml");
            try {
                return new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() == 0 ? Optional.of(pipe) : Optional.empty();
            } catch (IOException noPipes) {
                return Optional.empty();
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        }
    }
}
