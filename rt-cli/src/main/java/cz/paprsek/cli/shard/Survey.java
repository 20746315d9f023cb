package cz.paprsek.cli.shard;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.shard.PartFile.OtherVersion;
import cz.paprsek.io.Failures;
import cz.paprsek.render.Tile;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * What a folder of parts has in it, by the heads of its files.
 *
 * @param frames those that were looked for; empty for all
 * @param card of the picture or film of which most is there; empty if nothing is
 * @param parts of it, whose heads are right
 * @param foreign a sentence for each part of another picture
 * @param damaged a sentence for each file that is no whole part
 */
public record Survey(Path folder, Optional<Span> frames, Optional<Card> card, List<Found> parts, List<String> foreign, List<String> damaged) {
    private static final int MOST_TOLD = 8;

    /** A part, where it is. */
    record Found(Path file, PartHead head) {}

    /**
     * Looks at all files, or those of some frames.
     *
     * @throws WrongUsage if there is no such folder
     * @throws IOException if it cannot be listed
     */
    public static Survey of(Path folder, Optional<Span> frames) throws IOException {
        return of(folder, frames, new Heads());
    }

    /** As {@link #of(Path, Optional)}, by what is known of files from an earlier look. */
    public static Survey of(Path folder, Optional<Span> frames, Heads heads) throws IOException {
        if (!Files.isDirectory(folder)) {
            throw new WrongUsage(folder + (Files.exists(folder) ? " is not a directory of parts" : ": there is no such directory"));
        }
        List<Found> found = new ArrayList<>();
        List<String> foreign = new ArrayList<>();
        List<String> damaged = new ArrayList<>();
        for (Path file : new PartsFolder(folder).files(frames)) {
            try {
                found.add(new Found(file, heads.of(file)));
            } catch (OtherVersion other) {
                foreign.add(file + " is " + other.getMessage());
            } catch (IOException wrong) {
                damaged.add(Failures.sentence(file.toString(), wrong));
            }
        }
        Optional<Card> card = most(found);
        Map<Boolean, List<Found>> own = found.stream().collect(Collectors.partitioningBy(part -> part.head().card().equals(card.orElseThrow())));
        own.getOrDefault(false, List.of()).forEach(part -> foreign.add(part.file() + " is " + part.head().card().difference(card.orElseThrow())));
        return new Survey(folder, frames, card, own.getOrDefault(true, List.of()), foreign, damaged);
    }

    private static Optional<Card> most(List<Found> found) {
        Map<Card, Long> pixels = found.stream().collect(Collectors.groupingBy(part -> part.head().card(), Collectors.summingLong(part -> (long) part.head().tile().width() * part.head().tile().height())));
        return pixels.entrySet().stream().max(Map.Entry.<Card, Long>comparingByValue().thenComparing(entry -> entry.getKey().text())).map(Map.Entry::getKey);
    }

    /** Without parts that turned out to be damaged. */
    Survey without(Map<Path, String> broken) {
        List<String> sentences = new ArrayList<>(damaged);
        sentences.addAll(broken.values());
        return new Survey(folder, frames, card, parts.stream().filter(part -> !broken.containsKey(part.file())).toList(), foreign, sentences);
    }

    /** Whether all of the picture is there, and nothing else. */
    public boolean isWhole() {
        return foreign.isEmpty() && !parts.isEmpty() && lacking(covered()).findAny().isEmpty();
    }

    /** The frames of which something is missing. */
    private IntStream lacking(IntFunction<Coverage> covered) {
        Tile region = card.orElseThrow().region();
        return IntStream.rangeClosed(span().first(), span().last()).filter(frame -> !covered.apply(frame).covers(region));
    }

    /** The frames of the film, or those of it that were looked for; of a picture that is none, its only one. */
    public Span span() {
        return frames.orElseGet(this::dealt);
    }

    /** The frames that were dealt out, from the first of all to the last of all: a film may have been made longer. */
    public Span dealt() {
        return parts.stream().map(part -> part.head().span()).reduce(Span::with).orElseThrow();
    }

    /** The parts of each frame, by itself. */
    public SortedMap<Integer, Survey> byFrame() {
        return parts.stream().filter(part -> span().has(part.head().frame())).collect(Collectors.groupingBy(part -> part.head().frame(), TreeMap::new, Collectors.collectingAndThen(Collectors.toList(),
                own -> new Survey(folder, frames, card, own, foreign, damaged))));
    }

    /** What is there of each frame. */
    private IntFunction<Coverage> covered() {
        Card own = card.orElseThrow();
        Map<Integer, List<PartHead>> heads = parts.stream().map(Found::head).collect(Collectors.groupingBy(PartHead::frame));
        Map<Integer, Coverage> frames = new HashMap<>();
        heads.forEach((frame, all) -> frames.put(frame, new Coverage(own, all)));
        Coverage nothing = new Coverage(own, List.of());
        return frame -> frames.getOrDefault(frame, nothing);
    }

    /**
     * What stands in the way of the picture, a sentence each: files first, then what is missing, then the line that makes it.
     *
     * @throws InterruptedIOException if a stop is asked for before all is known
     * @throws IOException if the folder cannot be listed
     */
    public List<String> obstacles(Stop stop) throws IOException {
        List<String> sentences = new ArrayList<>(foreign);
        sentences.addAll(damaged);
        if (parts.isEmpty() && sentences.isEmpty() && frames.isPresent() && !new PartsFolder(folder).files(Optional.empty()).isEmpty()) {
            sentences.add(folder + ": none of its parts is of the frames asked for; without --frames, all that is there is put together");
            return sentences;
        }
        if (parts.isEmpty()) {
            sentences.add(folder + ": there is no part of a picture in it; paprsek render SCENE --shard I/N -o " + Again.quoted(folder.toString()) + " makes them");
            return sentences;
        }
        IntFunction<Coverage> covered = covered();
        if (lacking(covered).findAny().isPresent()) {
            sentences.add(folder + ": " + missing(covered) + "; this makes them, where the others were made:");
            sentences.add(line(covered, stop));
        }
        return sentences;
    }

    private String missing(IntFunction<Coverage> covered) {
        if (!span().isStill()) {
            return "tiles are missing in " + lacking(covered).count() + " of " + span().count() + " frames: " + told(lacking(covered).mapToObj(String::valueOf));
        }
        Tile region = card.orElseThrow().region();
        int passes = card.orElseThrow().passes();
        if (covered.apply(0).isInPasses()) {
            List<Integer> some = IntStream.rangeClosed(1, passes).filter(pass -> !covered.apply(0).covers(pass, region)).boxed().toList();
            return "tiles are missing in " + some.size() + " of " + passes + " passes: " + told(some.stream().map(String::valueOf));
        }
        List<Tile> tiles = Grid.tiles(region, Grid.SIDE);
        List<Tile> missing = tiles.stream().filter(tile -> !covered.apply(0).covers(tile)).toList();
        return missing.size() + " of " + tiles.size() + " tiles are missing: " + told(missing.stream().map(tile -> tile.x() + "," + tile.y() + "," + tile.width() + "," + tile.height()));
    }

    private static String told(Stream<String> places) {
        List<String> first = places.limit(MOST_TOLD + 1L).toList();
        return first.stream().limit(MOST_TOLD).collect(Collectors.joining(" ")) + (first.size() > MOST_TOLD ? " and others" : "");
    }

    /** What makes all that is missing, by the shares into which most of the parts were dealt. */
    private String line(IntFunction<Coverage> covered, Stop stop) throws InterruptedIOException {
        boolean isByPasses = usual(part -> part.pass() > 0, part -> true, Comparator.<Boolean>naturalOrder());
        int count = usual(part -> part.shard().count(), part -> part.pass() > 0 == isByPasses, Comparator.<Integer>naturalOrder());
        Predicate<PartHead> alike = part -> part.shard().count() == count && part.pass() > 0 == isByPasses;
        Span usual = usual(PartHead::span, alike, Comparator.comparing(Span::first).thenComparing(Span::last));
        List<String> usualWords = usual(PartHead::words, alike.and(part -> part.span().equals(usual)), Comparator.comparing(List::toString));
        int passes = isByPasses ? card.orElseThrow().passes() : 0;
        Span all = usual.with(span());
        List<String> words = all.equals(usual) ? usualWords : Again.ofFrames(usualWords, all);
        List<Integer> shares = new Deal(card.orElseThrow().region(), all, passes, count).owners(piece -> span().has(piece.frame()) && !covered.apply(piece.frame()).covers(piece.pass(), piece.tile()), stop);
        return Again.line(words, shares, count, folder);
    }

    /** What most of the parts have. */
    private <T> T usual(Function<PartHead, T> what, Predicate<PartHead> which, Comparator<T> order) {
        return parts.stream().map(Found::head).filter(which).collect(Collectors.groupingBy(what, Collectors.counting())).entrySet().stream()
                .max(Map.Entry.<T, Long>comparingByValue().thenComparing(Map.Entry.comparingByKey(order))).orElseThrow().getKey();
    }
}
