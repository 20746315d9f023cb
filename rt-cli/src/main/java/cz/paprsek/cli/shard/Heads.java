package cz.paprsek.cli.shard;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.HashMap;
import java.util.Map;

/** The heads of part files, of which each is read once unless its file changes: for who looks again and again. */
public final class Heads {
    private final Map<Path, Known> files = new HashMap<>();
    private final Map<Object, Object> shared = new HashMap<>();

    private record Known(long size, FileTime time, PartHead head) {}

    /** @throws IOException as {@link PartFile#head} */
    PartHead of(Path file) throws IOException {
        BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
        Known known = files.get(file);
        if (known == null || known.size != now.size() || !known.time.equals(now.lastModifiedTime())) {
            known = new Known(now.size(), now.lastModifiedTime(), shared(PartFile.head(file)));
            files.put(file, known);
        }
        return known.head;
    }

    /** Thousands of parts have one card between them. */
    private PartHead shared(PartHead head) {
        return new PartHead(same(head.card()), same(head.told()), head.frame(), head.pass(), head.tile(), same(head.span()), same(head.shard()), same(head.words()));
    }

    @SuppressWarnings("unchecked")
    private <T> T same(T value) {
        return (T) shared.computeIfAbsent(value, key -> key);
    }
}
