package cz.paprsek.cli.shard;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.shard.Deal.Piece;
import cz.paprsek.cli.value.Shard;
import cz.paprsek.render.Tile;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleBinaryOperator;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DealTest {
    @ParameterizedTest
    @CsvSource({"1,1,0,0,0,1", "1920,1080,0,0,0,8", "1920,1080,0,0,0,5000", "640,361,1,8,0,8", "100,70,3,1000,0,7", "33,31,0,0,0,3", "640,361,0,0,6,3", "640,361,0,0,40,5", "640,361,0,0,3,8",
            "100,70,3,90,4,7", "100,70,3,9,16,5", "100,70,3,9,2,5"})
    void everyPixelOfEveryPassOfEveryFrameIsDealtOnce(int width, int height, int first, int last, int passes, int shards) {
        Tile region = new Tile(5, 7, width, height);
        Deal deal = new Deal(region, new Span(first, last), passes, shards);
        List<Piece> all = new ArrayList<>();
        for (int i = 1; i <= shards; i++) {
            all.addAll(deal.of(new Shard(i, shards)));
        }
        assertThat(new HashSet<>(all)).hasSize(all.size()).hasSize((int) deal.parts());
        assertThat(all).allMatch(piece -> Grid.has(region, piece.tile()));
        for (int frame : new int[] {first, last}) {
            for (int pass = Math.min(1, passes); pass <= passes; pass++) {
                Piece any = new Piece(frame, pass, region);
                Grid grid = new Grid(region);
                List<Tile> tiles = all.stream().filter(piece -> piece.frame() == any.frame() && piece.pass() == any.pass()).map(Piece::tile).toList();
                tiles.forEach(grid::cover);
                assertThat(grid.covers(region)).isTrue();
                assertThat(tiles.stream().mapToLong(tile -> (long) tile.width() * tile.height()).sum()).isEqualTo((long) width * height);
            }
        }
    }

    /** Those whose work has such a piece, and nobody else. */
    @ParameterizedTest
    @CsvSource({"0,0,0,3", "0,0,0,500", "1,8,0,8", "3,90,0,7", "0,0,40,5", "0,0,3,8", "3,90,4,7", "3,9,16,5", "3,9,2,5"})
    void ownersOfPiecesAreThoseWhoseWorkTheyAre(int first, int last, int passes, int shards) throws IOException {
        Deal deal = new Deal(new Tile(5, 7, 320, 130), new Span(first, last), passes, shards);
        List<Predicate<Piece>> some = List.of(piece -> true, piece -> false, piece -> piece.tile().x() == 5 && piece.tile().y() == 7, piece -> piece.frame() % 5 == 0 && piece.pass() == passes,
                piece -> piece.frame() > first + 3 && piece.tile().x() > 200);
        for (Predicate<Piece> which : some) {
            List<Integer> expected = IntStream.rangeClosed(1, shards).filter(i -> deal.of(new Shard(i, shards)).stream().anyMatch(which)).boxed().toList();
            assertThat(deal.owners(which, new Stop())).isEqualTo(expected);
        }
    }

    /** Nobody has two parts more than another, of pictures and of few frames, whatever their passes; of many frames, whole ones are dealt out. */
    @ParameterizedTest
    @CsvSource({"1920,1080,0,0,0", "512,288,0,0,0", "333,777,0,0,0", "33,31,0,0,0", "100,2000,1,7,0", "640,361,1,3,0", "320,130,0,0,7", "64,48,0,0,17", "320,130,0,0,64", "320,130,0,0,1000",
            "320,130,1,3,50"})
    void nobodyHasTwoPartsMoreThanAnother(int width, int height, int first, int last, int passes) {
        for (int shards : new int[] {1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 13, 16, 30, 64, 500}) {
            Deal deal = new Deal(new Tile(5, 7, width, height), new Span(first, last), passes, shards);
            IntSummaryStatistics counts = IntStream.rangeClosed(1, shards).map(i -> deal.of(new Shard(i, shards)).size()).summaryStatistics();
            assertThat(counts.getMax() - counts.getMin()).as(shards + " shares").isLessThanOrEqualTo(1);
            assertThat(counts.getSum()).isEqualTo(deal.parts());
        }
    }

    /** Of a picture whose middle takes ten times as long as its corners, and whose lower half three times as long as its upper. */
    @ParameterizedTest
    @CsvSource({"2,0.001", "3,0.001", "5,0.002", "8,0.002", "13,0.005", "21,0.01", "30,0.02", "64,0.06"})
    void noShareTakesMuchLongerThanTheMean(int shards, double longer) {
        assertThat(longest(1920, 1080, shards, (x, y) -> (1 + 9 * Math.exp(-20 * (x * x + y * y))) * (y > 0 ? 3 : 1))).isLessThan(longer);
    }

    /** Of pictures in which every second column of tiles takes ten times as long, or every third row, or more and more to the right, or one disc. */
    @ParameterizedTest
    @CsvSource({"2,0.01,0.01", "3,0.01,0.01", "4,0.01,0.01", "5,0.01,0.02", "7,0.02,0.02", "8,0.02,0.03", "13,0.02,0.05", "16,0.03,0.05", "30,0.03,0.15"})
    void shareOfColumnsAndRowsAndWhatLiesTogetherIsEven(int shards, double longer, double longerOfDisc) {
        assertThat(longest(1920, 1080, shards, (x, y) -> (int) ((x + 0.5) * 60) % 2 == 0 ? 10 : 1)).isLessThan(longer);
        assertThat(longest(1920, 1080, shards, (x, y) -> (int) ((y + 0.5) * 1080 / 32) % 3 == 0 ? 10 : 1)).isLessThan(longer);
        assertThat(longest(1920, 1080, shards, (x, y) -> 1.5 + x)).isLessThan(longer);
        assertThat(longest(1920, 1080, shards, (x, y) -> Math.hypot(x + 0.2, 0.56 * y) < 0.2 ? 8 : 1)).isLessThan(longerOfDisc);
    }

    /** By how much the longest share is longer than the mean, by what a pixel costs at a place between −1/2 and 1/2. */
    private static double longest(int width, int height, int shards, DoubleBinaryOperator cost) {
        Deal deal = new Deal(new Tile(0, 0, width, height), Span.STILL, 0, shards);
        double[] times = IntStream.rangeClosed(1, shards).mapToDouble(i -> deal.of(new Shard(i, shards)).stream().map(Piece::tile).mapToDouble(tile -> tile.width() * tile.height()
                * cost.applyAsDouble((tile.x() + tile.width() / 2.0) / width - 0.5, (tile.y() + tile.height() / 2.0) / height - 0.5)).sum()).toArray();
        return DoubleStream.of(times).max().orElseThrow() / DoubleStream.of(times).average().orElseThrow() - 1;
    }

    @Test
    void aPictureHasManyPartsForEachShareAndNoMoreThanItHasCells() {
        assertThat(new Deal(new Tile(0, 0, 256, 256), new Span(1, 8), 0, 8).parts()).isEqualTo(512);
        assertThat(new Deal(new Tile(0, 0, 1920, 1080), Span.STILL, 0, 1).parts()).isEqualTo(510);
        assertThat(new Deal(new Tile(0, 0, 64, 33), Span.STILL, 0, 1000).parts()).isEqualTo(4);
    }

    /** To prepare each frame on all machines would take longer than to render it. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 7, 10, 16})
    void ofManyFramesEverybodyGetsWholeOnesWithAllTheirPasses(int passes) {
        Deal deal = new Deal(new Tile(0, 0, 640, 360), new Span(1, 80), passes, 10);
        List<Piece> own = deal.of(new Shard(3, 10));
        assertThat(own.stream().map(Piece::frame).distinct()).containsExactly(3, 13, 23, 33, 43, 53, 63, 73);
        assertThat(own).hasSize((int) (deal.parts() / 10));
    }

    /** Of one frame, and of a few: whole passes if there are as many for each. */
    @ParameterizedTest
    @CsvSource({"0,0,6,3", "0,0,40,5", "1,4,16,8", "1,70,3,10"})
    void ofFewFramesWithManyPassesEverybodyGetsWholePasses(int first, int last, int passes, int shards) {
        Deal deal = new Deal(new Tile(0, 0, 640, 360), new Span(first, last), passes, shards);
        long tiles = deal.parts() / ((last - first + 1L) * passes);
        for (int i = 1; i <= shards; i++) {
            assertThat(deal.of(new Shard(i, shards)).stream().collect(Collectors.groupingBy(piece -> List.of(piece.frame(), piece.pass()), Collectors.counting())).values())
                    .isNotEmpty().allMatch(count -> count == tiles);
        }
    }

    /** Of a few passes beyond as many for each, everybody gets tiles. */
    @ParameterizedTest
    @CsvSource({"0,0,17,2", "0,0,64,7", "1,79,3,10"})
    void passesThatAreLeftOverAreDealtOutByTiles(int first, int last, int passes, int shards) {
        Deal deal = new Deal(new Tile(0, 0, 640, 360), new Span(first, last), passes, shards);
        long slices = (last - first + 1L) * passes;
        long tiles = deal.parts() / slices;
        for (int i = 1; i <= shards; i++) {
            Map<List<Integer>, Long> counts = deal.of(new Shard(i, shards)).stream().collect(Collectors.groupingBy(piece -> List.of(piece.frame(), piece.pass()), Collectors.counting()));
            assertThat(counts.values().stream().filter(count -> count == tiles).count()).isEqualTo(slices / shards);
            assertThat(counts.values().stream().filter(count -> count < tiles).mapToLong(count -> count).sum()).isBetween(slices % shards * tiles / shards, slices % shards * tiles / shards + 1);
        }
    }
}
