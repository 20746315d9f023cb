package cz.paprsek.spark;

import cz.paprsek.cli.Embedded;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.shard.Piecework;
import cz.paprsek.cli.shard.Span;
import cz.paprsek.io.Failures;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.apache.spark.SparkConf;
import org.apache.spark.TaskContext;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.broadcast.Broadcast;
import org.apache.spark.util.LongAccumulator;

/**
 * Renders a picture or film by a cluster, to the same bytes as one machine: {@code spark-submit --class cz.paprsek.spark.SparkRender rt-spark.jar scene.xml --frames 1-1000 -o file:///films/}. Words are those
 * of {@code paprsek render}. Its tiles are tasks, or of a long film its frames; a task that fails is tried again by Spark, and who is killed loses the tile under way.
 */
public final class SparkRender {
    private static final int DONE = 0;
    private static final int FAILED = 1;
    private static final int WRONG_USAGE = 2;
    /** As many tiles for each processor even out that some take longer than others. */
    private static final int TILES_EACH = 16;
    /** From as many frames for each processor on, each is made by one of them: it is prepared once. */
    private static final int FRAMES_EACH = 8;
    /** The driver remembers every task of a stage. */
    private static final int MOST_TASKS = 50_000;

    private static final String HELP = """
            Usage: spark-submit --class cz.paprsek.spark.SparkRender rt-spark.jar SCENE -o OUTPUT [--side PIXELS]
                   [--format FORMAT] [--bits N] [--uncompressed] [WORDS OF RENDER]
            OUTPUT is a name in any file system that the cluster's Hadoop knows, or a directory, which ends in /.
            --side says how many pixels tiles have along each side, a multiple of 32. The other words are those of
            'paprsek render', without --shard, --resume, --time, --mistake and --denoise:
            """;

    private SparkRender() {}

    /** Exits as {@code paprsek render} does: 0 if all is done, 2 for wrong usage, 3 for a scene that is not valid, 1 if a task has failed as often as Spark lets it. */
    public static void main(String[] words) {
        System.exit(run(List.of(words)));
    }

    private static int run(List<String> all) {
        if (all.contains("--help") || all.contains("-h")) {
            System.out.println(HELP);
            return Embedded.run(System.out, new PrintWriter(System.err, true, StandardCharsets.UTF_8), List.of("render", "--help"));
        }
        try {
            Words words = Words.of(all);
            Piecework piecework = Workshop.ordered(words.order(), words.order());
            words.check();
            return run(words, piecework);
        } catch (IllegalArgumentException | WrongUsage wrong) {
            return failed(String.valueOf(wrong.getMessage()), WRONG_USAGE);
        } catch (Workshop.Refused refused) {
            return failed(String.valueOf(refused.getMessage()), refused.code());
        } catch (IOException lost) {
            return failed(Failures.sentence(lost), FAILED);
        }
    }

    private static int run(Words words, Piecework piecework) throws IOException {
        try (JavaSparkContext spark = new JavaSparkContext(settings(piecework))) {
            Span span = piecework.span();
            boolean isLong = span.count() >= (long) FRAMES_EACH * spark.defaultParallelism();
            int side = words.side().orElseGet(() -> piecework.side(isLong ? 1 : (long) TILES_EACH * spark.defaultParallelism()));
            int tiles = piecework.tiles(side).size();
            Places places = Places.of(words.output(), span, withoutEnding(piecework.scene()), words.ending(), piecework.card() + words.written(), spark.hadoopConfiguration());
            places.prepare();
            Broadcast<Job> job = spark.broadcast(job(words, piecework, side, places));
            LongAccumulator made = spark.sc().longAccumulator("tiles rendered");
            if (isLong) {
                frames(spark, job, made, span, tiles);
            } else {
                tiles(spark, job, made, span, tiles);
            }
            places.clear();
            System.out.println(piecework.scene() + " -> " + places.picture() + "  " + span.count() + (span.count() == 1 ? " picture, " : " pictures, ") + made.value() + " tiles of " + side + "x" + side
                    + " pixels rendered" + (made.value() < (long) tiles * span.count() ? ", others were there before" : ""));
            return DONE;
        } catch (Exception failure) {
            // Spark's own exceptions are not declared where Java can see them.
            return failed(cause(failure), FAILED);
        }
    }

    private static SparkConf settings(Piecework piecework) {
        // Kryo cannot read records, whatever the cluster prefers.
        return new SparkConf().setIfMissing("spark.app.name", "paprsek " + piecework.scene()).set("spark.serializer", "org.apache.spark.serializer.JavaSerializer");
    }

    private static void frames(JavaSparkContext spark, Broadcast<Job> job, LongAccumulator made, Span span, int tiles) {
        for (int first = span.first(); first <= span.last(); first += MOST_TASKS) {
            int last = Math.min(span.last(), first + MOST_TASKS - 1);
            spark.setJobDescription("frames " + first + " to " + last);
            work(spark, job, made, Unit.frames(first, last, tiles));
        }
    }

    private static void tiles(JavaSparkContext spark, Broadcast<Job> job, LongAccumulator made, Span span, int tiles) {
        int frames = Math.max(1, MOST_TASKS / tiles);
        for (int first = span.first(); first <= span.last(); first += frames) {
            int last = Math.min(span.last(), first + frames - 1);
            spark.setJobDescription(span.isStill() ? "tiles" : "tiles of frames " + first + " to " + last);
            work(spark, job, made, Unit.tiles(first, last, tiles));
            spark.setJobDescription(span.isStill() ? "the picture" : "pictures of frames " + first + " to " + last);
            List<Integer> whole = Unit.frames(first, last, tiles).stream().map(Unit::frame).toList();
            spark.parallelize(new ArrayList<>(whole), whole.size()).foreach(frame -> job.value().workshop().merge(frame));
        }
    }

    private static void work(JavaSparkContext spark, Broadcast<Job> job, LongAccumulator made, List<Unit> units) {
        spark.parallelize(units, units.size()).foreach(unit -> {
            TaskContext task = TaskContext.get();
            made.add(job.value().workshop().work(unit, task::isInterrupted));
        });
    }

    private static Job job(Words words, Piecework piecework, int side, Places places) throws IOException {
        Path scene = piecework.scene();
        String name = String.valueOf(scene.getFileName());
        if (!Files.isRegularFile(scene) || !words.render().contains(scene.toString())) {
            throw new IOException(scene + " is not a file of one scene, by its name");
        }
        Map<String, byte[]> files = piecework.files();
        files.put(name, Files.readAllBytes(scene));
        return new Job(name, files, new ArrayList<>(Words.elsewhere(words.order(), scene.toString(), name)), new ArrayList<>(words.written()), words.ending(), piecework.card(), side, places);
    }

    private static String withoutEnding(Path scene) {
        String name = String.valueOf(scene.getFileName());
        return name.contains(".") ? name.substring(0, name.lastIndexOf('.')) : name;
    }

    /** The first line of what Spark tells: a stack of it follows. */
    private static String cause(Exception failure) {
        return String.valueOf(failure.getMessage()).lines().findFirst().orElse(failure.getClass().getSimpleName());
    }

    private static int failed(String sentence, int code) {
        (code == DONE ? System.out : System.err).println(sentence);
        return code;
    }
}
