package cz.paprsek.cli.shard;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.shard.Deal.Piece;
import cz.paprsek.cli.value.Shard;
import cz.paprsek.render.Tile;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
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

    /** Of a picture whose middle takes ten times as long as its corners, and whose lower half three times as long as its upper. */
    @ParameterizedTest
    @CsvSource({"2,0.02", "3,0.03", "5,0.02", "8,0.03", "13,0.05", "21,0.1", "30,0.1", "64,0.2"})
    void noShareTakesMuchLongerThanTheMean(int shards, double longer) {
        Deal deal = new Deal(new Tile(0, 0, 1920, 1080), Span.STILL, 0, shards);
        double[] times = IntStream.rangeClosed(1, shards).mapToDouble(i -> deal.of(new Shard(i, shards)).stream().mapToDouble(piece -> time(piece.tile())).sum()).toArray();
        assertThat(DoubleStream.of(times).max().orElseThrow()).isLessThan((1 + longer) * DoubleStream.of(times).average().orElseThrow());
    }

    private static double time(Tile tile) {
        double x = (tile.x() + tile.width() / 2.0) / 1920 - 0.5;
        double y = (tile.y() + tile.height() / 2.0) / 1080 - 0.5;
        return tile.width() * tile.height() * (1 + 9 * Math.exp(-20 * (x * x + y * y))) * (y > 0 ? 3 : 1);
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

    /** Of one frame, and of a few: whole passes if there are enough of them, or as many for each. */
    @ParameterizedTest
    @CsvSource({"0,0,6,3", "0,0,40,5", "0,0,41,5", "1,4,16,8", "1,79,3,10"})
    void ofFewFramesWithManyPassesEverybodyGetsWholePasses(int first, int last, int passes, int shards) {
        Deal deal = new Deal(new Tile(0, 0, 640, 360), new Span(first, last), passes, shards);
        long tiles = deal.parts() / ((last - first + 1L) * passes);
        for (int i = 1; i <= shards; i++) {
            assertThat(deal.of(new Shard(i, shards)).stream().collect(Collectors.groupingBy(piece -> List.of(piece.frame(), piece.pass()), Collectors.counting())).values())
                    .isNotEmpty().allMatch(count -> count == tiles);
        }
    }
}
