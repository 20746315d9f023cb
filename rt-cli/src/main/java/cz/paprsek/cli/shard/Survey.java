package cz.paprsek.cli.shard;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.shard.PartFile.OtherVersion;
import cz.paprsek.io.Failures;
import cz.paprsek.render.Tile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * What a folder of parts has in it, by the heads of its files.
 *
 * @param card of the picture of which most is there; empty if nothing is
 * @param parts of that picture, whose heads are right
 * @param foreign a sentence for each part of another picture
 * @param damaged a sentence for each file that is no whole part
 */
public record Survey(Path folder, Optional<Card> card, List<Found> parts, List<String> foreign, List<String> damaged) {

    private static final int MOST_TOLD = 8;

    /** A part, where it is. */
    record Found(Path file, PartHead head) {}

    /**
     * Looks at all files.
     *
     * @throws WrongUsage if there is no such folder
     * @throws IOException if it cannot be listed
     */
    public static Survey of(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            throw new WrongUsage(folder + (Files.exists(folder) ? " is not a directory of parts" : ": there is no such directory"));
        }
        List<Found> found = new ArrayList<>();
        List<String> foreign = new ArrayList<>();
        List<String> damaged = new ArrayList<>();
        Map<Object, Object> known = new HashMap<>();
        for (Path file : new PartsFolder(folder).files()) {
            try {
                PartHead head = PartFile.head(file);
                // Thousands of parts have one card between them.
                found.add(new Found(file, new PartHead(same(known, head.card()), head.frame(), head.tile(), same(known, head.shard()), same(known, head.words()))));
            } catch (OtherVersion other) {
                foreign.add(file + " is " + other.getMessage());
            } catch (IOException wrong) {
                damaged.add(Failures.sentence(file.toString(), wrong));
            }
        }
        Optional<Card> card = most(found);
        Map<Boolean, List<Found>> own = found.stream().collect(Collectors.partitioningBy(part -> part.head().card().equals(card.orElseThrow())));
        own.getOrDefault(false, List.of()).forEach(part -> foreign.add(part.file() + " is " + part.head().card().difference(card.orElseThrow())));
        return new Survey(folder, card, own.getOrDefault(true, List.of()), foreign, damaged);
    }

    @SuppressWarnings("unchecked")
    private static <T> T same(Map<Object, Object> known, T value) {
        return (T) known.computeIfAbsent(value, key -> key);
    }

    private static Optional<Card> most(List<Found> found) {
        Map<Card, Long> pixels = found.stream().collect(Collectors.groupingBy(part -> part.head().card(), Collectors.summingLong(part -> (long) part.head().tile().width() * part.head().tile().height())));
        return pixels.entrySet().stream().max(Map.Entry.<Card, Long>comparingByValue().thenComparing(entry -> entry.getKey().text())).map(Map.Entry::getKey);
    }

    /** Without parts that turned out to be damaged. */
    Survey without(Map<Path, String> broken) {
        List<String> sentences = new ArrayList<>(damaged);
        sentences.addAll(broken.values());
        return new Survey(folder, card, parts.stream().filter(part -> !broken.containsKey(part.file())).toList(), foreign, sentences);
    }

    /** Whether all of the picture is there, and nothing else. */
    public boolean isWhole() {
        return card.isPresent() && foreign.isEmpty() && missing() == 0;
    }

    /** How many cells of the picture are in no part. */
    int missing() {
        return card.map(one -> covered().missing(one.region())).orElse(0);
    }

    private Grid covered() {
        Grid grid = new Grid(card.orElseThrow().region());
        parts.forEach(part -> grid.cover(part.head().tile()));
        return grid;
    }

    /** What stands in the way of the picture, a sentence each: files first, then what is missing, then the line that makes it. */
    public List<String> obstacles() {
        List<String> sentences = new ArrayList<>(foreign);
        sentences.addAll(damaged);
        if (card.isEmpty()) {
            sentences.add(folder + ": there is no part of a picture in it; paprsek render SCENE --shard I/N -o " + Again.quoted(folder.toString()) + " makes them");
            return sentences;
        }
        if (missing() > 0) {
            sentences.addAll(lacking());
        }
        return sentences;
    }

    /** What is missing, by the shares into which most of the parts were dealt. */
    private List<String> lacking() {
        Grid grid = covered();
        Tile region = card.orElseThrow().region();
        List<Tile> tiles = Grid.tiles(region, Grid.SIDE).stream().filter(tile -> !grid.covers(tile)).toList();
        String places = tiles.stream().limit(MOST_TOLD).map(tile -> tile.x() + "," + tile.y() + "," + tile.width() + "," + tile.height()).collect(Collectors.joining(" "));
        int count = usual(part -> part.shard().count(), part -> true, Comparator.<Integer>naturalOrder());
        List<String> words = usual(PartHead::words, part -> part.shard().count() == count, Comparator.comparing(List::toString));
        List<Integer> shares = new Deal(region, count).owners(piece -> !grid.covers(piece.tile()));
        return List.of(folder + ": " + tiles.size() + " of " + grid.cells() + " tiles are missing: " + places + (tiles.size() > MOST_TOLD ? " and others" : "") + "; this makes them, where the others were made:",
                Again.line(words, shares, count, folder));
    }

    /** What most of the parts have. */
    private <T> T usual(Function<PartHead, T> what, Predicate<PartHead> which, Comparator<T> order) {
        return parts.stream().map(Found::head).filter(which).collect(Collectors.groupingBy(what, Collectors.counting())).entrySet().stream()
                .max(Map.Entry.<T, Long>comparingByValue().thenComparing(Map.Entry.comparingByKey(order))).orElseThrow().getKey();
    }
}
