package cz.paprsek.xml;

import cz.paprsek.xml.SceneFiles.Contents;
import cz.paprsek.xml.bind.ThoroughReader;
import cz.paprsek.xml.format.FileScenes;
import cz.paprsek.xml.quick.QuickReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/**
 * From a file to scenes: by the {@link QuickReader} if it is good and plain. Else by the {@link ThoroughReader}: that takes six times as long, and
 * tells every problem.
 */
final class SceneReader {
    private SceneReader() {}

    /** What a source is heard by on its way to a reader; asked for each reader anew. */
    interface Listening {
        InputStream to(InputStream input) throws IOException;
    }

    static Contents read(Path file, ReadMonitor monitor) throws SceneFileException, IOException {
        try (Source source = Source.of(file)) {
            long size = source.size();
            return read(source, input -> new WatchedInput(input, size, monitor), file.toString());
        }
    }

    static Contents read(InputStream input, String file) throws SceneFileException, IOException {
        Objects.requireNonNull(input, "input");
        Objects.requireNonNull(file, "file");
        return read(Source.of(input), heard -> heard, file);
    }

    /** The stream that was listened to last is read to its end. */
    static Contents read(Source source, Listening listening, String file) throws SceneFileException, IOException {
        InputStream first = new LimitedInput(listening.to(source.fromStart()), file, SceneFiles.LARGEST);
        Optional<FileScenes> quick = QuickReader.read(first);
        if (quick.isPresent()) {
            first.transferTo(OutputStream.nullOutputStream());
            return contents(quick.get());
        }
        InputStream second = new LimitedInput(listening.to(source.fromStart()), file, SceneFiles.LARGEST);
        Contents found = thoroughly(second, file);
        second.transferTo(OutputStream.nullOutputStream());
        return found;
    }

    /** As above; what the text says of its encoding does not matter, since it is a text already. */
    static Contents read(String given, String file) throws SceneFileException, IOException {
        String text = given.startsWith("\uFEFF") ? given.substring(1) : given;
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        // Halves of characters, which no bytes stand for, are told apart from question marks.
        Optional<FileScenes> quick = new String(bytes, StandardCharsets.UTF_8).equals(text)
                ? QuickReader.read(new ByteArrayInputStream(bytes)) : Optional.empty();
        return quick.isPresent() ? contents(quick.get()) : contents(ThoroughReader.read(text, file), file);
    }

    /** Without the quick reader. */
    static Contents thoroughly(InputStream input, String file) throws SceneFileException, IOException {
        return contents(ThoroughReader.read(input, file), file);
    }

    private static Contents contents(ThoroughReader.Outcome outcome, String file) throws SceneFileException {
        if (!outcome.mistakes().isEmpty()) {
            throw new SceneFileException(outcome.mistakes().stream().map(one -> new Problem(file, one.line(), one.column(), one.message())).toList());
        }
        return contents(outcome.scenes());
    }

    private static Contents contents(FileScenes found) {
        return new Contents(found.scenes(), found.isDatabase());
    }
}
