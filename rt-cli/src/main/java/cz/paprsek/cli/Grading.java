package cz.paprsek.cli;

import cz.paprsek.asset.Assets;
import cz.paprsek.cli.output.GradeProgress;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageComparison;
import cz.paprsek.image.StoredImage;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.PlainTracer;
import cz.paprsek.teach.grade.Grade;
import cz.paprsek.teach.grade.Grade.Verdict;
import cz.paprsek.teach.grade.Grader;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;

/** Grades pictures of one scene. What is rendered for one serves for all others of its size. */
final class Grading {
    /** So many steps of 1/255 may be rounding, here and there. */
    private static final double TOLERANCE = 2;
    /** So few pixels that are farther off may be edges. */
    private static final double FEW = 0.001;

    private final Scene scene;
    private final RenderScene ready;
    private final boolean areSamplesKnown;
    private final Stop stop;
    private final Map<List<Integer>, Right> bySize = new HashMap<>();

    /** What pictures of one size are compared with; without a grader if the plain tracer does not know the scene. */
    private record Right(List<StoredImage> pictures, List<Grader> grader) {}

    /**
     * What there is to say of a picture.
     *
     * @param right the right picture
     * @param distance how far it is from that
     * @param wrong the right one, or that with the mistakes that explain it
     * @param left how far it is from that one
     * @param unknown what of the scene keeps mistakes from being looked for
     */
    record Graded(StoredImage given, StoredImage right, ImageComparison distance, Grade grade, StoredImage wrong, ImageComparison left, List<String> unknown) {}

    /** @param areSamplesKnown whether the pictures have the samples of the scene, or perhaps one ray a pixel */
    Grading(Scene scene, Assets assets, boolean areSamplesKnown, Stop stop) {
        this.scene = scene;
        this.areSamplesKnown = areSamplesKnown;
        this.stop = stop;
        this.ready = RenderScene.of(scene, assets, monitor());
    }

    private RenderMonitor monitor() {
        return new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return stop.requested();
            }
        };
    }

    Graded of(StoredImage read, GradeProgress progress) {
        StoredImage given = new StoredImage(read.image(), Precision.EIGHT_BIT, read.isGrey());
        RenderSettings settings = scene.settings().withSize(given.image().width(), given.image().height());
        Right right = bySize.computeIfAbsent(List.of(settings.width(), settings.height()), size -> {
            progress.rendering();
            return right(settings);
        });
        StoredImage nearest = right.pictures.stream().min(Comparator.comparingDouble(one -> ImageComparison.of(given, one, TOLERANCE).mean())).orElseThrow();
        ImageComparison distance = ImageComparison.of(given, nearest, TOLERANCE);
        boolean isRight = distance.shareBeyond() <= FEW;
        Grade grade = isRight ? new Grade(Verdict.RIGHT, List.of(), 1, settings.samples())
                : right.grader.isEmpty() ? new Grade(Verdict.UNEXPLAINED, List.of(), 0, settings.samples()) : right.grader.get(0).grade(given, progress);
        StoredImage wrong = grade.explanations().isEmpty() ? nearest : wrong(settings.withSamples(grade.samples()), grade.explanations().get(0));
        return new Graded(given, nearest, distance, grade, wrong, ImageComparison.of(given, wrong, TOLERANCE), PlainTracer.unknown(scene, settings));
    }

    private StoredImage wrong(RenderSettings settings, Mistakes made) {
        return eightBit(PlainTracer.of(scene, settings, made).render(stop::requested));
    }

    private Right right(RenderSettings settings) {
        List<StoredImage> pictures = new ArrayList<>();
        Stream.of(settings, settings.withSamples(settings.samples()), settings.withSamples(1)).distinct().limit(areSamplesKnown || settings.isPath() ? 1 : 3)
                .forEach(one -> pictures.add(rendered(one)));
        boolean isKnown = PlainTracer.unknown(scene, settings).isEmpty();
        return new Right(pictures, isKnown ? List.of(new Grader(scene, settings, areSamplesKnown, stop::requested)) : List.of());
    }

    private StoredImage rendered(RenderSettings settings) {
        RenderResult result = Renderer.render(ready, RenderOptions.of(settings), monitor());
        if (result.outcome() == RenderResult.Outcome.CANCELLED) {
            throw new CancellationException("asked to stop");
        }
        return eightBit(result.image());
    }

    private static StoredImage eightBit(Image image) {
        return new StoredImage(image, Precision.EIGHT_BIT, false);
    }
}
