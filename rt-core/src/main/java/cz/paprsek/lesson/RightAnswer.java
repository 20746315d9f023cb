package cz.paprsek.lesson;

import cz.paprsek.lesson.Question.Found;
import cz.paprsek.lesson.Question.Given;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.Pixel.PathPixel;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.text.Outline;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The right numbers of a question: those that are said, or those of the scene. */
final class RightAnswer {
    private RightAnswer() {}

    /**
     * Finds them.
     *
     * @throws IllegalArgumentException if the pixel has no such figure
     */
    static List<Double> of(Question question, Lesson lesson) {
        return question.answer() instanceof Given given ? given.numbers() : found((Found) question.answer(), RenderScene.of(lesson.scene(), lesson.assets(), RenderMonitor.NONE));
    }

    private static List<Double> found(Found asked, RenderScene ready) {
        RenderSettings settings = ready.scene().settings();
        if (asked.figure().isOfPixel() && settings.isPath()) {
            PathPixel pixel = ready.explainPaths(RenderOptions.of(settings), asked.column(), asked.row(), RenderMonitor.NONE);
            return asked.figure().of(pixel.light(), pixel.developed());
        }
        Pixel pixel = ready.explain(settings.isPath() ? Seen.whitted(settings) : settings, asked.column(), asked.row());
        if (asked.figure().isOfPixel()) {
            return asked.figure().of(pixel.light(), pixel.developed());
        }
        TracedRay ray = named(Outline.of(pixel.rays().get(pixel.typical())), asked.ray()).map(Outline::ray)
                .orElseThrow(() -> new IllegalArgumentException(at(asked) + " has no ray " + asked.ray()));
        return asked.figure().of(ray, asked.light() - 1).orElseThrow(() -> new IllegalArgumentException(
                at(asked) + " has no " + asked.figure() + ": ray " + asked.ray() + " meets " + met(ray, ready.scene(), asked.light())));
    }

    private static String at(Found asked) {
        return "pixel " + asked.column() + "," + asked.row();
    }

    private static String met(TracedRay ray, Scene scene, int light) {
        return ray.encounter().map(met -> met.place().surface() + (light > scene.lights().size() ? ", and there is no light " + light : "")).orElse("nothing");
    }

    private static Optional<Outline> named(Outline outline, String name) {
        return Stream.concat(outline.name().equals(name) ? Stream.of(outline) : Stream.empty(),
                outline.children().stream().filter(child -> name.startsWith(child.name())).flatMap(child -> named(child, name).stream())).findFirst();
    }
}
