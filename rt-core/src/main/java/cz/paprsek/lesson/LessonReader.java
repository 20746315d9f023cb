package cz.paprsek.lesson;

import cz.paprsek.asset.Assets;
import cz.paprsek.io.Failures;
import cz.paprsek.lesson.Lesson.Formula;
import cz.paprsek.lesson.Lesson.Look;
import cz.paprsek.lesson.Lesson.Paragraph;
import cz.paprsek.lesson.Lesson.Part;
import cz.paprsek.lesson.Question.Answer;
import cz.paprsek.lesson.Question.Found;
import cz.paprsek.lesson.Question.Given;
import cz.paprsek.lesson.Question.Slip;
import cz.paprsek.query.Filter;
import cz.paprsek.query.FilterException;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.text.Numbers;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Makes a lesson of its file's elements. Other files that it needs are in the same folder or below, and nowhere else. */
final class LessonReader {
    private static final List<String> PARTS = List.of("p", "formula", "look", "question", "task");
    private static final List<String> LANGUAGES = List.of("en", "cs");

    private final String file;
    private final Assets folder;

    private LessonReader(String file, Assets folder) {
        this.file = file;
        this.folder = folder;
    }

    /**
     * Reads a lesson, and looks whether its questions have answers.
     *
     * @param name what it is to be called
     * @param file the name of its file in the folder
     * @param path its file
     * @param folder its files
     */
    static Lesson read(String name, String file, Path path, Assets folder) throws LessonException, IOException {
        Tag root = Tag.read(bytes(folder, file), path.toString());
        Lesson lesson = new LessonReader(path.toString(), folder).lesson(name, Optional.of(path.toAbsolutePath().normalize()), root);
        List<Tag> questions = root.all("question");
        for (int i = 0; i < questions.size(); i++) {
            checkAnswer(questions.get(i), lesson.questions().get(i), lesson);
        }
        return lesson;
    }

    /** Reads a lesson that is known to have answers: finding them takes a while. */
    static Lesson shipped(String name, String file, String shown, Assets folder) throws LessonException, IOException {
        return new LessonReader(shown, folder).lesson(name, Optional.empty(), Tag.read(bytes(folder, file), shown));
    }

    private static byte[] bytes(Assets folder, String file) throws IOException {
        ByteBuffer content = folder.bytes(file);
        byte[] bytes = new byte[content.remaining()];
        content.get(bytes);
        return bytes;
    }

    private Lesson lesson(String name, Optional<Path> path, Tag root) throws LessonException {
        if (!root.name().equals("lesson")) {
            throw root.wrong("a lesson begins with <lesson>, not with <" + root.name() + ">");
        }
        root.mayHave(List.of("scene"));
        root.mayHold(Stream.concat(Stream.of("title"), PARTS.stream()).toList());
        Scene scene = scene(root, "scene");
        Said title = said(root.only("title"));
        List<Part> parts = new ArrayList<>();
        for (Tag tag : root.children()) {
            if (PARTS.contains(tag.name())) {
                parts.add(part(tag, scene));
            }
        }
        return new Lesson(name, path, title, scene, folder, parts);
    }

    private Part part(Tag tag, Scene scene) throws LessonException {
        return switch (tag.name()) {
            case "p" -> new Paragraph(said(tag));
            case "formula" -> new Formula(tag.children().isEmpty() ? Said.inAll(tag.words()) : said(tag));
            case "look" -> look(tag, scene.settings());
            case "question" -> question(tag, scene);
            default -> task(tag);
        };
    }

    private Look look(Tag tag, RenderSettings settings) throws LessonException {
        tag.mayHave(List.of("pixel"));
        int[] pixel = pixel(tag, settings);
        tag.mayHold(LANGUAGES);
        return new Look(pixel[0], pixel[1], new Said(tag.only("en").words(), tag.only("cs").words()));
    }

    private Question question(Tag tag, Scene scene) throws LessonException {
        tag.mayHave(List.of("answer", "asks", "pixel", "ray", "light", "tolerance"));
        tag.mayHold(List.of("en", "cs", "hint", "why", "wrong"));
        Answer answer = answer(tag, scene);
        List<Double> tolerance = tag.numbers("tolerance");
        if (tolerance.size() != 1 || !(tolerance.get(0) > 0)) {
            throw tag.wrong("<question> tolerance must be a number above 0, but is \"" + tag.needed("tolerance") + "\"");
        }
        List<Slip> slips = new ArrayList<>();
        for (Tag wrong : tag.all("wrong")) {
            wrong.mayHave(List.of("answer"));
            wrong.mayHold(LANGUAGES);
            slips.add(new Slip(wrong.numbers("answer"), new Said(wrong.only("en").words(), wrong.only("cs").words())));
        }
        return new Question(new Said(tag.only("en").words(), tag.only("cs").words()), answer, tolerance.get(0), said(tag.only("hint")), said(tag.only("why")), slips);
    }

    private Answer answer(Tag tag, Scene scene) throws LessonException {
        if (tag.attribute("asks").isPresent() == tag.attribute("answer").isPresent()) {
            throw tag.wrong("<question> needs either the attribute answer, or asks and pixel");
        }
        if (tag.attribute("answer").isPresent()) {
            for (String needless : List.of("pixel", "ray", "light")) {
                if (tag.attribute(needless).isPresent()) {
                    throw tag.wrong("<question> has an answer, so it has no attribute " + needless);
                }
            }
            return new Given(tag.numbers("answer"));
        }
        List<String> known = Stream.of(Figure.values()).map(Figure::toString).toList();
        Figure figure = Figure.of(tag.needed("asks")).orElseThrow(() -> tag.wrong("<question> asks must be one of " + String.join(", ", known) + ", but is \""
                + tag.attribute("asks").orElse("") + "\""));
        int[] pixel = pixel(tag, scene.settings());
        return new Found(figure, pixel[0], pixel[1], tag.attribute("ray").orElse("E"), tag.whole("light", 1, 1, Math.max(1, scene.lights().size())));
    }

    /** That there is one, and that no wrong answer is as near to it as a right one. */
    private static void checkAnswer(Tag tag, Question question, Lesson lesson) throws LessonException {
        List<Double> right;
        try {
            right = RightAnswer.of(question, lesson);
        } catch (IllegalArgumentException none) {
            throw tag.wrong("<question> has no answer: " + none.getMessage());
        } catch (UncheckedIOException unreadable) {
            throw tag.wrong("<question> has no answer, because the scene lacks a file: " + Failures.sentence(unreadable));
        }
        for (Tag wrong : tag.all("wrong")) {
            List<Double> numbers = wrong.numbers("answer");
            if (numbers.size() != right.size()) {
                throw wrong.wrong("<wrong> answer has " + numbers.size() + (numbers.size() == 1 ? " number" : " numbers") + ", but the right one " + right.size());
            }
            if (question.isNear(numbers, right)) {
                throw wrong.wrong("<wrong> answer is right: it is within the tolerance of " + right.stream().map(Numbers::text).collect(Collectors.joining(" ")));
            }
        }
    }

    private Task task(Tag tag) throws LessonException {
        tag.mayHave(List.of("condition", "solution"));
        tag.mayHold(List.of("en", "cs", "hint", "why"));
        Filter<Seen> condition;
        try {
            condition = Filter.parse(tag.needed("condition"), Seen.TABLE);
        } catch (FilterException e) {
            throw tag.wrong("<task> condition: " + e.getMessage());
        }
        if (condition.toString().isBlank()) {
            throw tag.wrong("<task> condition is empty, and would be met from the beginning");
        }
        return new Task(new Said(tag.only("en").words(), tag.only("cs").words()), condition, said(tag.only("hint")), said(tag.only("why")), scene(tag, "solution"));
    }

    private static Said said(Tag tag) throws LessonException {
        tag.mayHave(List.of());
        tag.mayHold(LANGUAGES);
        return new Said(tag.only("en").words(), tag.only("cs").words());
    }

    private static int[] pixel(Tag tag, RenderSettings settings) throws LessonException {
        String[] words = tag.needed("pixel").strip().split(",", -1);
        try {
            int column = Integer.parseInt(words[0].strip());
            int row = words.length == 2 ? Integer.parseInt(words[1].strip()) : -1;
            if (column >= 0 && row >= 0 && column < settings.width() && row < settings.height()) {
                return new int[] {column, row};
            }
        } catch (NumberFormatException none) {
            // Told below.
        }
        throw tag.wrong("<" + tag.name() + "> pixel must be a column and a row of the scene's picture, " + settings.width() + " x " + settings.height()
                + ", such as 0,0, but is \"" + tag.needed("pixel") + "\"");
    }

    private Scene scene(Tag tag, String attribute) throws LessonException {
        String name = tag.needed(attribute);
        try {
            List<Scene> scenes = SceneFiles.contents(new ByteArrayInputStream(bytes(folder, name)), beside(name)).scenes();
            if (scenes.size() != 1) {
                throw tag.wrong(name + " is a database of " + scenes.size() + " scenes, but one scene was expected");
            }
            return scenes.get(0);
        } catch (SceneFileException e) {
            throw new LessonException(e.problems());
        } catch (IOException e) {
            throw tag.wrong("<" + tag.name() + "> " + attribute + ": " + e.getMessage());
        }
    }

    /** The scene's file as it is called seen from where the lesson's is. */
    private String beside(String scene) {
        int slash = Math.max(file.lastIndexOf('/'), file.lastIndexOf('\\'));
        return file.substring(0, slash + 1) + scene;
    }
}
