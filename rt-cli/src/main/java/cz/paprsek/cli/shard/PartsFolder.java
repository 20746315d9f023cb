package cz.paprsek.cli.shard;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.shard.Deal.Piece;
import cz.paprsek.cli.shard.PartFile.OtherVersion;
import cz.paprsek.cli.shard.PartFile.Pixels;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Folders;
import cz.paprsek.render.Tile;
import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A folder of part files; those of a film lie in folders of their frames in it. */
record PartsFolder(Path path) {
    private static final Pattern NAME = Pattern.compile("tile-(\\d{5})-(\\d{5})-(\\d{1,5})x(\\d{1,5})" + Pattern.quote(PartFile.ENDING));
    private static final Pattern PASS = Pattern.compile("pass-\\d{5}");
    private static final Pattern FRAME = Pattern.compile("frame-(\\d{6,9})");

    /** Where a part goes. */
    Path file(Piece piece) {
        Tile tile = piece.tile();
        return of(piece.frame(), piece.pass()).resolve(String.format(Locale.ROOT, "tile-%05d-%05d-%dx%d%s", tile.x(), tile.y(), tile.width(), tile.height(), PartFile.ENDING));
    }

    /** Makes the folder of a frame, or of one of its passes, and removes what processes that are no more have left half-written in it. */
    void prepare(int frame, int pass) throws IOException {
        Path folder = of(frame, pass);
        Folders.make(folder);
        AtomicFile.sweepAll(folder, PartFile.ENDING);
    }

    /** The folder of a frame, or of one of its passes, from 1. */
    private Path of(int frame, int pass) {
        Path all = frame == 0 ? path : path.resolve(String.format(Locale.ROOT, "frame-%06d", frame));
        return pass == 0 ? all : all.resolve(String.format(Locale.ROOT, "pass-%05d", pass));
    }

    /** All part files of some frames, or of all, in the order of their names. */
    List<Path> files(Optional<Span> frames) throws IOException {
        List<Path> files = new ArrayList<>(frames.isEmpty() ? partsOfAllPasses(path) : List.of());
        for (Path folder : listed(path, each -> isFrame(each, frames))) {
            files.addAll(partsOfAllPasses(folder));
        }
        return files.stream().sorted().toList();
    }

    private static boolean isFrame(Path folder, Optional<Span> frames) {
        Matcher name = FRAME.matcher(String.valueOf(folder.getFileName()));
        return name.matches() && (frames.isEmpty() || frames.get().has(Integer.parseInt(name.group(1)))) && Files.isDirectory(folder);
    }

    private static List<Path> partsOfAllPasses(Path frame) throws IOException {
        List<Path> files = new ArrayList<>(parts(frame));
        for (Path folder : listed(frame, each -> PASS.matcher(String.valueOf(each.getFileName())).matches() && Files.isDirectory(each))) {
            files.addAll(parts(folder));
        }
        return files;
    }

    private static List<Path> parts(Path folder) throws IOException {
        return Files.isDirectory(folder) ? listed(folder, file -> file.toString().endsWith(PartFile.ENDING)) : List.of();
    }

    private static List<Path> listed(Path folder, DirectoryStream.Filter<Path> which) throws IOException {
        List<Path> files = new ArrayList<>();
        try (DirectoryStream<Path> all = Files.newDirectoryStream(folder, which)) {
            all.forEach(files::add);
        } catch (DirectoryIteratorException hindered) {
            throw hindered.getCause();
        }
        return files;
    }

    /**
     * Which pieces of work on a frame are not done: their pixels are in no part that is whole, neither of their pass nor of all.
     *
     * @throws WrongUsage if there are parts of another picture in their place
     */
    List<Piece> lacking(Card card, int frame, List<Piece> pieces) throws IOException {
        Grid wanted = new Grid(card.region());
        pieces.forEach(piece -> wanted.cover(piece.tile()));
        Grid whole = there(card, frame, 0, wanted, new Grid(card.region()));
        SortedMap<Integer, Grid> passes = new TreeMap<>();
        for (Piece piece : pieces) {
            if (piece.pass() > 0 && !passes.containsKey(piece.pass())) {
                passes.put(piece.pass(), there(card, frame, piece.pass(), wanted, whole));
            }
        }
        return pieces.stream().filter(piece -> !passes.getOrDefault(piece.pass(), whole).covers(piece.tile())).toList();
    }

    /** What is there of a pass, or of all, beside what is known to be. */
    private Grid there(Card card, int frame, int pass, Grid wanted, Grid known) throws IOException {
        Grid there = known.copy();
        for (Path file : parts(of(frame, pass))) {
            Optional<Tile> tile = tile(file).filter(named -> Grid.has(card.region(), named) && wanted.touches(named));
            if (tile.isPresent() && isWhole(card, file, new Piece(frame, pass, tile.get()))) {
                there.cover(tile.get());
            }
        }
        return there;
    }

    private boolean isWhole(Card card, Path file, Piece piece) throws IOException {
        try {
            PartHead head = PartFile.read(file, Pixels.IGNORED);
            if (!head.card().equals(card)) {
                throw foreign(file, head.card().difference(card));
            }
            return head.frame() == piece.frame() && head.pass() == piece.pass() && head.tile().equals(piece.tile());
        } catch (OtherVersion other) {
            throw foreign(file, String.valueOf(other.getMessage()));
        } catch (IOException damaged) {
            // It is made again.
            return false;
        }
    }

    private WrongUsage foreign(Path file, String how) {
        return new WrongUsage(file + " is " + how + "; delete what is in " + path + " to begin anew, or name another directory");
    }

    /** Which pixels a file should hold by its name. */
    private static Optional<Tile> tile(Path file) {
        Matcher name = NAME.matcher(String.valueOf(file.getFileName()));
        try {
            return name.matches() ? Optional.of(new Tile(number(name, 1), number(name, 2), number(name, 3), number(name, 4))) : Optional.empty();
        } catch (IllegalArgumentException none) {
            return Optional.empty();
        }
    }

    private static int number(Matcher name, int group) {
        return Integer.parseInt(name.group(group));
    }
}
