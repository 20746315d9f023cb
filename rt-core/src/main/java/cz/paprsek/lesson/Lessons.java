package cz.paprsek.lesson;

import cz.paprsek.asset.Assets;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;

/** The lessons that are shipped, and those in files of others. */
public final class Lessons {
    /** The names of those that are shipped, in the order in which they are held. */
    public static final List<String> NAMES = List.of(
            "camera-rays", "sphere", "plane-and-block", "csg-on-a-line", "phong", "shadows", "mirrors", "snell", "antialiasing", "indirect-light");

    private static final String FOLDER = "cz/paprsek/lesson/";
    private static final long LARGEST = 1 << 24;

    private Lessons() {}

    /**
     * One of those that are shipped. That its questions have answers, and its wrong ones are wrong, has been looked at before it was shipped.
     *
     * @throws IllegalArgumentException if there is none of that name
     */
    public static Lesson shipped(String name) {
        if (!NAMES.contains(Objects.requireNonNull(name, "name"))) {
            throw new IllegalArgumentException("there is no lesson \"" + name + "\"; there are " + String.join(", ", NAMES));
        }
        return inJar(name);
    }

    /** The tour of the editor: step by step a bowl with handles is built. It is about hands, and none of the lessons that are held in a class. */
    public static Lesson tour() {
        return inJar("tour");
    }

    private static Lesson inJar(String name) {
        try {
            return LessonReader.shipped(name, "lesson.xml", name + "/lesson.xml", Assets.in(Lessons.class.getClassLoader(), FOLDER + name));
        } catch (LessonException | IOException e) {
            throw new IllegalStateException("the lesson " + name + " in the program's own jar cannot be read: " + e.getMessage(), e);
        }
    }

    /**
     * Reads the lesson of a file; its scenes and their files are in the same folder or below.
     *
     * @throws LessonException if it is not valid, with what is wrong and where
     * @throws IOException if it cannot be read
     */
    public static Lesson read(Path file) throws LessonException, IOException {
        Path name = Objects.requireNonNull(file, "file").getFileName();
        String called = name == null ? file.toString() : name.toString();
        Assets folder = Assets.beside(file).withLimits(LARGEST, 4 * LARGEST);
        return LessonReader.read(called.replaceFirst("\\.[^.]*$", ""), called, file, folder);
    }

    /** The right numbers of a question of a lesson. */
    public static List<Double> answer(Lesson lesson, Question question) {
        return RightAnswer.of(Objects.requireNonNull(question, "question"), Objects.requireNonNull(lesson, "lesson"));
    }

    /** The schema of lessons' files, an XSD. */
    public static String schema() {
        try (InputStream input = Objects.requireNonNull(Lessons.class.getResourceAsStream("lesson.xsd"), "lesson.xsd is missing")) {
            return new String(input.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new IllegalStateException("the schema in the program's own jar cannot be read", e);
        }
    }
}
