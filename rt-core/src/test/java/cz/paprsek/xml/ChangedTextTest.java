package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.scene.Scene;
import cz.paprsek.xml.text.FileText;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Random scenes, laid out at random, and changed at random: what is saved is what was wanted, and what was not changed stays. */
class ChangedTextTest {
    private static final Pattern COMMENT = Pattern.compile("<!-- c(\\d+)");
    private static final int FILES = 15;

    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"UTF-8", "UTF-16LE", "UTF-16BE"})
    void aSceneThatHasNotChangedChangesNoByte(String charset) throws Exception {
        for (int seed = 0; seed < FILES; seed++) {
            Path file = laidOut(RandomScenes.of(seed), seed, charset);
            byte[] before = Files.readAllBytes(file);
            SceneFile opened = SceneFiles.open(file);
            assertThat(Files.readAllBytes(opened.save(SceneFiles.parse(SceneFiles.format(opened.scene()))).path())).isEqualTo(before);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"UTF-8", "UTF-16LE"})
    void whatIsSavedIsWhatWasWantedAndUndoneIsAsItWas(String charset) throws Exception {
        for (int seed = 0; seed < FILES; seed++) {
            Path file = laidOut(RandomScenes.of(seed), seed, charset);
            byte[] before = Files.readAllBytes(file);
            RandomEdits edits = new RandomEdits(seed);
            SceneFile opened = SceneFiles.open(file);
            Scene first = opened.scene();
            Scene scene = first;
            for (int i = 0; i < 6; i++) {
                scene = edits.any(scene);
                assertThat(patched(before, scene)).as("seed %d, edit %d", seed, i).isPresent();
                opened = opened.save(scene);
                Scene read = SceneFiles.open(file).scene();
                assertThat(read).isEqualTo(scene);
                assertThat(read.materials().keySet()).containsExactlyElementsOf(scene.materials().keySet());
            }
            opened.save(SceneFiles.parse(SceneFiles.format(first)));
            assertThat(Files.readAllBytes(file)).isEqualTo(before);
        }
    }

    /** Without falling back to a text that is written anew. */
    private Optional<byte[]> patched(byte[] before, Scene wanted) throws Exception {
        OriginalText text = OriginalText.read(Files.write(folder.resolve("base.xml"), before), ReadMonitor.NONE);
        return text.patched(new FileText(before), List.of(wanted), SceneFiles.DEEPEST + 1);
    }

    @Test
    void everyCommentStaysWhereNothingIsTakenAway() throws Exception {
        for (int seed = 0; seed < 3 * FILES; seed++) {
            Path file = laidOut(RandomScenes.of(seed), seed, "UTF-8");
            Set<Integer> before = comments(file);
            SceneFile opened = SceneFiles.open(file);
            Scene scene = new RandomEdits(seed).keeping(opened.scene());
            opened.save(scene);
            assertThat(SceneFiles.open(file).scene()).isEqualTo(scene);
            assertThat(comments(file)).as("seed %d", seed).isEqualTo(before);
        }
    }

    private Path laidOut(Scene scene, long seed, String charset) throws Exception {
        String text = RandomLayout.of(SceneFiles.format(scene), seed);
        boolean isUtf8 = charset.equals("UTF-8");
        String declared = isUtf8 ? text : "\uFEFF" + text.replace("encoding=\"utf-8\"", "encoding=\"UTF-16\"");
        return Files.writeString(folder.resolve("a.xml"), declared, isUtf8 ? StandardCharsets.UTF_8 : Charset.forName(charset));
    }

    private static Set<Integer> comments(Path file) throws Exception {
        Set<Integer> numbers = new TreeSet<>();
        List<Integer> all = new ArrayList<>();
        COMMENT.matcher(Files.readString(file)).results().map((MatchResult found) -> Integer.parseInt(found.group(1))).forEach(all::add);
        numbers.addAll(all);
        assertThat(all).as("no comment is there twice").hasSameSizeAs(numbers);
        return numbers;
    }
}
