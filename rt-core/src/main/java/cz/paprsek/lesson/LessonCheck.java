package cz.paprsek.lesson;

import cz.paprsek.io.Failures;
import cz.paprsek.render.RenderMonitor;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/** Whether a lesson's tasks are tasks: not done to begin with, and done in their solutions. That its questions are, is looked at when it is read. */
public final class LessonCheck {
    private LessonCheck() {}

    /** What is wrong with its tasks, in sentences; none if nothing is. */
    public static List<String> problems(Lesson lesson, RenderMonitor monitor) {
        Objects.requireNonNull(monitor, "monitor");
        List<String> problems = new ArrayList<>();
        for (Task task : lesson.tasks()) {
            String which = "task " + (lesson.tasks().indexOf(task) + 1) + ": ";
            try {
                if (task.isDone(lesson.scene(), lesson.assets(), monitor)) {
                    problems.add(which + "its condition is met by the scene that the lesson begins with");
                }
                if (!task.isDone(task.solution(), lesson.assets(), monitor)) {
                    problems.add(which + "its condition is not met by its solution");
                }
            } catch (UncheckedIOException | IllegalArgumentException notToBeSeen) {
                problems.add(which + Failures.sentence(notToBeSeen));
            }
        }
        return problems;
    }
}
