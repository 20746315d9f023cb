package cz.paprsek.cli.input;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.cli.process.WrongUsage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class SceneArgumentsTest {
    @TempDir
    Path folder;

    @BeforeEach
    void writeFiles() throws IOException {
        Files.createDirectories(folder.resolve("deep/er"));
        for (String name : List.of("b.xml", "a.xml", "a.png", "deep/c.xml", "deep/er/d.xml", "odd[1].xml")) {
            Files.createFile(folder.resolve(name));
        }
    }

    private List<String> files(String... words) {
        return SceneArguments.files(List.of(words)).stream().map(file -> folder.relativize(file).toString().replace('\\', '/')).toList();
    }

    @Test
    void aPatternGivesItsFilesSorted() {
        assertThat(files(folder + "/?.xml")).containsExactly("a.xml", "b.xml");
        assertThat(files(folder + "/{b,a}.*")).containsExactly("a.png", "a.xml", "b.xml");
        assertThat(files(folder + "/*/*.xml")).containsExactly("deep/c.xml");
        assertThat(files(folder + "/**.xml")).containsExactly("a.xml", "b.xml", "deep/c.xml", "deep/er/d.xml", "odd[1].xml");
    }

    @Test
    void twoStarsMayBeNoFolder() {
        assertThat(files(folder + "/**/*.xml")).containsExactly("a.xml", "b.xml", "deep/c.xml", "deep/er/d.xml", "odd[1].xml");
        assertThat(files(folder + "/**/er/**/d.xml")).containsExactly("deep/er/d.xml");
        assertThat(files(folder + "/deep/**")).containsExactly("deep/c.xml", "deep/er/d.xml");
        assertThat(files(folder + "/d*/**/{c,d}.xml")).containsExactly("deep/c.xml", "deep/er/d.xml");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void aLinkThatLeadsInACircleHidesNothing() throws IOException {
        Files.createSymbolicLink(folder.resolve("deep/er/up"), folder);
        assertThat(files(folder + "/**/*.xml")).contains("a.xml", "deep/c.xml", "deep/er/d.xml");
    }

    @Test
    void noFileIsThereTwice() {
        assertThat(files(folder + "/b.xml", folder + "/?.xml", folder + "/deep/../a.xml")).containsExactly("b.xml", "a.xml");
    }

    @Test
    void aFileWhoseNameLooksLikeAPatternIsMeantItself() {
        assertThat(files(folder + "/odd[1].xml")).containsExactly("odd[1].xml");
    }

    @Test
    void whatMatchesNothingStaysAndIsMissedLater() {
        assertThat(files(folder + "/no*.xml", folder + "/none/*.xml")).containsExactly("no*.xml", "none/*.xml");
    }

    @Test
    void aPatternInTheWorkingDirectoryHasNoDot() {
        assertThat(SceneArguments.files(List.of("pom.*"))).containsExactly(Path.of("pom.xml"));
        assertThat(SceneArguments.files(List.of("../scenes/show*.xml"))).containsExactly(Path.of("../scenes/showcase.xml"));
    }

    @Test
    void aBrokenPatternIsExplained() {
        assertThatThrownBy(() -> files(folder + "/[a.xml")).isInstanceOf(WrongUsage.class).hasMessageContaining("not a valid pattern");
    }
}
