package cz.paprsek.lesson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.lesson.Lesson.Formula;
import cz.paprsek.lesson.Lesson.Look;
import cz.paprsek.lesson.Lesson.Paragraph;
import cz.paprsek.lesson.Lesson.Part;
import cz.paprsek.lesson.Question.Mark;
import cz.paprsek.lesson.Question.Slip;
import cz.paprsek.lesson.Question.Verdict;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

/** The ten lessons that are shipped. */
class LessonsTest {
    static final List<String> NAMES = Lessons.NAMES;

    /** What pen and paper have for their questions, lesson by lesson. */
    private static final Map<String, List<List<Double>>> BY_HAND = Map.ofEntries(
            Map.entry("camera-rays", List.of(List.of(49.5 * pixel(), 25.5 * pixel()), unit(49.5 * pixel(), 25.5 * pixel(), -1))),
            Map.entry("sphere", List.of(List.of(5 - Math.sqrt(1 - 0.36)), List.of(0.6, 0.0, 0.8))),
            Map.entry("plane-and-block", List.of(List.of(3 / 0.6), List.of(3.5 / 0.8))),
            Map.entry("csg-on-a-line", List.of(List.of(4 + 1.25), List.of(4 - 1.25, 4.0), List.of(0.0, 0.0, 1.0))),
            Map.entry("phong", List.of(List.of(0.8), List.of(Math.pow(0.8, 10)), List.of(0.1 + 0.5 * 0.8 + 0.5 * Math.pow(0.8, 10)))),
            Map.entry("shadows", List.of(List.of(0.0), List.of(0.5 * 4 / 2), List.of(Math.hypot(0.8, 4)))),
            Map.entry("mirrors", List.of(List.of(0.0, 0.6, -0.8), List.of(0.25), List.of(Math.ceil(Math.log(0.01) / Math.log(0.5))))),
            Map.entry("snell", List.of(List.of(Math.toDegrees(Math.asin(0.8 / 1.5))), List.of(Math.toDegrees(Math.asin(1 / 1.5))), List.of(1.5 * Math.sqrt(1 - 0.64 / 2.25)))),
            Map.entry("antialiasing", List.of(List.of(1.0), List.of(0.75), List.of(255 * (1.055 * Math.pow(0.75, 1 / 2.4) - 0.055)))),
            Map.entry("indirect-light", List.of(List.of(0.2 * 1.75), List.of(0.2 / 0.5), List.of(64.0 * 16))));

    private static double pixel() {
        return 2 * Math.tan(Math.toRadians(30)) / 100;
    }

    private static List<Double> unit(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return List.of(x / length, y / length, z / length);
    }

    private static String typed(List<Double> numbers) {
        return numbers.stream().map(String::valueOf).collect(Collectors.joining(" "));
    }

    @ParameterizedTest
    @FieldSource("NAMES")
    void rightAnswersAreTakenAndTheUsualWrongOnesAreToldWhatTheyDid(String name) {
        Lesson lesson = Lessons.shipped(name);
        List<List<Double>> answers = BY_HAND.getOrDefault(name, List.of());
        assertThat(lesson.questions()).hasSameSizeAs(answers);
        for (int i = 0; i < lesson.questions().size(); i++) {
            Question question = lesson.questions().get(i);
            List<Double> right = Lessons.answer(lesson, question);
            List<Double> byHand = answers.get(i);
            assertThat(right).hasSameSizeAs(byHand);
            assertThat(question.mark(typed(byHand), right)).as("%s, question %d: %s", name, i + 1, right).isEqualTo(new Mark(Verdict.RIGHT, Optional.of(question.why()), ""));
            for (int k = 0; k < right.size(); k++) {
                assertThat(right.get(k)).isCloseTo(byHand.get(k), within(question.tolerance() / 2 + 1e-9));
            }
            assertThat(question.slips()).isNotEmpty();
            for (Slip slip : question.slips()) {
                assertThat(question.mark(typed(slip.numbers()), right)).isEqualTo(new Mark(Verdict.WRONG, Optional.of(slip.told()), ""));
            }
        }
    }

    @ParameterizedTest
    @FieldSource("NAMES")
    void tasksAreNotDoneToBeginWithAndAreInTheirSolutions(String name) {
        Lesson lesson = Lessons.shipped(name);
        assertThat(lesson.tasks()).hasSize(1);
        assertThat(LessonCheck.problems(lesson, RenderMonitor.NONE)).isEmpty();
    }

    @Test
    void theTourGoesFromStepToStep() {
        Lesson tour = Lessons.tour();
        assertThat(tour.tasks()).hasSize(10);
        assertThat(LessonCheck.problems(tour, RenderMonitor.NONE)).isEmpty();
        for (int i = 1; i < tour.tasks().size(); i++) {
            Scene before = tour.tasks().get(i - 1).solution();
            for (int k = 0; k < tour.tasks().size(); k++) {
                assertThat(tour.tasks().get(k).isDone(before, tour.assets(), RenderMonitor.NONE)).as("step %d after step %d", k + 1, i).isEqualTo(k < i);
            }
        }
    }

    @ParameterizedTest
    @FieldSource("NAMES")
    void allIsSaidInBothLanguages(String name) {
        Lesson lesson = Lessons.shipped(name);
        List<Said> all = lesson.parts().stream().flatMap(LessonsTest::said).toList();
        assertThat(all).hasSizeGreaterThan(8).allSatisfy(said -> {
            assertThat(said.english().equals(said.czech()) && said.english().matches(".*\\p{L}{3}.*")).as(said.english()).isFalse();
            assertThat(said.english()).endsWith(said.czech().substring(said.czech().length() - 1));
            // A Czech sentence has a comma where an English one has a point within a number.
            assertThat(said.czech()).doesNotContainPattern("\\d\\.\\d");
        });
        List<Said> formulas = lesson.parts().stream().filter(Formula.class::isInstance).map(part -> ((Formula) part).text()).toList();
        assertThat(formulas).isNotEmpty().allSatisfy(said -> {
            // The names of functions, and of what the scene file calls so, are the same everywhere.
            String own = said.english().replaceAll("\\b(sin|tan|max|fovy)\\b", "");
            assertThat(said.english().equals(said.czech()) && own.matches(".*\\p{L}{3}.*")).as(said.english()).isFalse();
            assertThat(said.czech()).doesNotContainPattern("\\d\\.\\d");
        });
    }

    private static Stream<Said> said(Part part) {
        if (part instanceof Paragraph paragraph) {
            return Stream.of(paragraph.text());
        }
        if (part instanceof Look look) {
            return Stream.of(look.text());
        }
        if (part instanceof Question question) {
            return Stream.concat(Stream.of(question.asked(), question.hint(), question.why()), question.slips().stream().map(Slip::told));
        }
        return part instanceof Task task ? Stream.of(task.asked(), task.hint(), task.why()) : Stream.of();
    }

    /** The closed room of the last lesson, rendered: every path brings just the sum of the series. */
    @Test
    void theClosedRoomOfTheLastLessonIsAsBrightAsItsSeries() throws Exception {
        String room = """
                <scene xmlns="urn:paprsek:scene:1"><render width="2" height="2" max-depth="%d" integrator="path" samples="1"/><background color="0 0 0"/>
                <camera position="0 0 0" direction="1 2 3"/><block min="-1 -1 -1" max="1 1 1">
                <material color="255 255 255" diffusion="0.5" emission="255 255 255" emission-strength="0.2"/></block></scene>
                """;
        for (int depth : new int[] {1, 2, 5}) {
            Scene scene = SceneFiles.read(new ByteArrayInputStream(room.formatted(depth).getBytes(StandardCharsets.UTF_8)), "room");
            assertThat((double) Renderer.render(scene).red(1, 1)).isCloseTo(0.4 * (1 - Math.pow(0.5, depth + 1)), within(1e-6));
        }
    }
}
