package cz.paprsek.lesson;

import cz.paprsek.asset.Assets;
import cz.paprsek.scene.Scene;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * A lesson: a scene, and what is told, asked and to be done about it, in the order in which it is read.
 *
 * @param name that of its file, or of its folder for those that are shipped
 * @param file the file that it was read from, absolute; empty for those that are shipped
 * @param scene to begin with
 * @param assets where the scene's files come from
 */
public record Lesson(String name, Optional<Path> file, Said title, Scene scene, Assets assets, List<Part> parts) {
    public Lesson {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(file, "file");
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(assets, "assets");
        parts = List.copyOf(parts);
    }

    /** Whether it is one of those that come with the program. */
    public boolean isShipped() {
        return file.isEmpty();
    }

    /** A piece of a lesson. */
    public sealed interface Part permits Paragraph, Formula, Look, Question, Task {}

    /** Something that is told. */
    public record Paragraph(Said text) implements Part {
        public Paragraph {
            Objects.requireNonNull(text, "text");
        }
    }

    /** A formula: in each language its own, or the same in all. */
    public record Formula(Said text) implements Part {
        public Formula {
            Objects.requireNonNull(text, "text");
        }
    }

    /**
     * A pixel whose explanation is worth a look.
     *
     * @param column from 0 at the left of the scene's picture
     * @param row from 0 at its top
     */
    public record Look(int column, int row, Said text) implements Part {
        public Look {
            Objects.requireNonNull(text, "text");
        }
    }

    /** Its questions, in their order. */
    public List<Question> questions() {
        return parts.stream().filter(Question.class::isInstance).map(Question.class::cast).toList();
    }

    /** Its tasks, in their order. */
    public List<Task> tasks() {
        return parts.stream().filter(Task.class::isInstance).map(Task.class::cast).toList();
    }
}
