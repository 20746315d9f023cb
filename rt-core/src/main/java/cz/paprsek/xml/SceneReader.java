package cz.paprsek.xml;

import cz.paprsek.scene.Animation;
import cz.paprsek.xml.SceneFiles.Contents;
import cz.paprsek.xml.bind.ThoroughReader;
import cz.paprsek.xml.format.FileScenes;
import cz.paprsek.xml.mistake.Mistake;
import cz.paprsek.xml.mistake.Problems;
import cz.paprsek.xml.quick.QuickReader;
import cz.paprsek.xml.text.AttributePlaces;
import cz.paprsek.xml.text.Places.Place;
import cz.paprsek.xml.text.Unpatchable;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.SequenceInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
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

    static Contents read(Path file, ReadMonitor monitor, Making how) throws SceneFileException, IOException {
        try (Source source = Source.of(file)) {
            long size = source.size();
            return read(source, input -> new WatchedInput(input, size, monitor), file.toString(), how);
        }
    }

    static Contents read(InputStream input, String file, Making how) throws SceneFileException, IOException {
        Objects.requireNonNull(input, "input");
        Objects.requireNonNull(file, "file");
        return read(Source.of(input), heard -> heard, file, how);
    }

    /** Whether nothing in it is of a parameter: what is written out knows those. */
    private static boolean isComplete(FileScenes found) {
        return found.scenes().stream().flatMap(scene -> scene.animations().stream()).noneMatch(Animation::isOfParameter);
    }

    /** The stream that was listened to last is read to its end. */
    static Contents read(Source source, Listening listening, String file, Making how) throws SceneFileException, IOException {
        try {
            return readAll(source, listening, file, how);
        } catch (OutOfMemoryError tooLarge) {
            throw new IOException(file + ": not enough memory for what is in this file; give Java more with -Xmx", tooLarge);
        }
    }

    private static Contents readAll(Source source, Listening listening, String file, Making how) throws SceneFileException, IOException {
        if (how.parameters().isEmpty()) {
            InputStream first = new LimitedInput(listening.to(source.fromStart()), file, SceneFiles.LARGEST);
            Optional<FileScenes> quick = QuickReader.read(first);
            if (quick.isPresent() && isComplete(quick.get())) {
                first.transferTo(OutputStream.nullOutputStream());
                return contents(quick.get());
            }
        }
        InputStream second = new LimitedInput(listening.to(source.fromStart()), file, SceneFiles.LARGEST);
        // Those that are longer are not written by hand.
        byte[] start = second.readNBytes(Making.LONGEST + 1);
        if (start.length <= Making.LONGEST) {
            Optional<Contents> made = how.contents(start, file);
            if (made.isPresent()) {
                return made.get();
            }
        }
        InputStream whole = new SequenceInputStream(new ByteArrayInputStream(start), second);
        ThoroughReader.Outcome outcome = ThoroughReader.read(whole, file);
        if (!outcome.mistakes().isEmpty()) {
            throw new SceneFileException(problems(outcome.mistakes(), source.again(), file));
        }
        second.transferTo(OutputStream.nullOutputStream());
        return contents(outcome.scenes());
    }

    /** Each where its attribute stands, if one is at fault, and the text is still there. */
    private static List<Problem> problems(List<Mistake> mistakes, Optional<InputStream> text, String file) throws IOException {
        List<Problem> problems = new ArrayList<>();
        try {
            AttributePlaces places = new AttributePlaces(text.orElse(InputStream.nullInputStream()));
            for (Mistake one : mistakes) {
                Place tag = new Place(one.line(), one.column());
                Place place = one.attributes().isEmpty() ? tag : places.of(tag, one.attributes()).orElse(tag);
                problems.add(new Problem(file, place.line(), place.column(), one.message()));
            }
        } catch (Unpatchable unknownEncoding) {
            return mistakes.stream().map(one -> new Problem(file, one.line(), one.column(), one.message())).toList();
        }
        boolean areMore = problems.size() > Problems.MOST;
        Problem last = problems.get(problems.size() - 1);
        problems.subList(0, problems.size() - (areMore ? 1 : 0)).sort(Comparator.comparingInt(Problem::line).thenComparingInt(Problem::column));
        if (areMore) {
            Problem before = problems.get(problems.size() - 2);
            problems.set(problems.size() - 1, new Problem(file, before.line(), before.column(), last.message()));
        }
        return problems;
    }

    /** As above; what the text says of its encoding does not matter, since it is a text already. */
    static Contents read(String given, String file) throws SceneFileException, IOException {
        String text = given.startsWith("\uFEFF") ? given.substring(1) : given;
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        // Halves of characters, which no bytes stand for, are told apart from question marks.
        Optional<FileScenes> quick = new String(bytes, StandardCharsets.UTF_8).equals(text)
                ? QuickReader.read(new ByteArrayInputStream(bytes)) : Optional.empty();
        if (quick.isPresent() && isComplete(quick.get())) {
            return contents(quick.get());
        }
        Optional<Contents> made = Making.PLAIN.contents(bytes, file);
        if (made.isPresent()) {
            return made.get();
        }
        ThoroughReader.Outcome outcome = ThoroughReader.read(text, file);
        if (!outcome.mistakes().isEmpty()) {
            throw new SceneFileException(problems(outcome.mistakes(), Optional.of(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_16))), file));
        }
        return contents(outcome.scenes());
    }

    /** Without the quick reader. */
    static Contents thoroughly(InputStream input, String file) throws SceneFileException, IOException {
        ThoroughReader.Outcome outcome = ThoroughReader.read(input, file);
        if (!outcome.mistakes().isEmpty()) {
            throw new SceneFileException(problems(outcome.mistakes(), Optional.empty(), file));
        }
        return contents(outcome.scenes());
    }

    private static Contents contents(FileScenes found) {
        return new Contents(found.scenes(), found.isDatabase());
    }
}
