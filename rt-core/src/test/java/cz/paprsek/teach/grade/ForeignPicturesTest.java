package cz.paprsek.teach.grade;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.ImageFiles;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.grade.Grade.Verdict;
import cz.paprsek.teach.mistake.Mistakes;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pictures that other programs have made: POV-Ray, Mitsuba, and a tracer as courses have it; how, says the page beside them. */
class ForeignPicturesTest {
    private static final Path FOLDER = Path.of("src/test/resources/cz/paprsek/teach/grade");

    private static Grade graded(String scene, String picture) throws Exception {
        Scene read = SceneFiles.read(FOLDER.resolve(scene + ".xml"));
        return new Grader(read, read.settings(), false, () -> false).grade(ImageFiles.readStored(FOLDER.resolve(picture + ".png")));
    }

    @ParameterizedTest
    @CsvSource({"three, course-right", "three, povray-right", "matt, mitsuba-right"})
    void rightOnesAreRight(String scene, String picture) throws Exception {
        assertThat(graded(scene, picture).verdict()).isEqualTo(Verdict.RIGHT);
    }

    /** A light of POV-Ray without shadows has no highlights either, which is found, too. Takes half a minute: to be had by {@code -Dpaprsek.proof}. */
    @EnabledIfSystemProperty(named = "paprsek.proof", matches = ".*")
    @ParameterizedTest
    @CsvSource({
        "three, course-full-fovy, full-fovy", "three, course-no-shadow, no-shadow", "three, course-corner, half-pixel", "three, course-upside-down, flip-y",
        "three, povray-full-fovy, full-fovy", "three, povray-no-shadow, no-highlight + no-shadow", "three, povray-no-mirror, no-reflection",
        "matt, mitsuba-full-fovy, full-fovy", "matt, mitsuba-linear, gamma-missing"})
    void wrongOnesAreToldWhatIsWrong(String scene, String picture, String mistakes) throws Exception {
        Grade grade = graded(scene, picture);
        assertThat(grade.verdict()).isEqualTo(Verdict.MISTAKEN);
        assertThat(grade.explanations().stream().map(Mistakes::toString)).contains(mistakes);
    }
}
