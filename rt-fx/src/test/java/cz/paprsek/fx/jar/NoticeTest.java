package cz.paprsek.fx.jar;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The jar of the editor names whose classes are in it, and under which licence. */
class NoticeTest {
    private static final Pattern JAR = Pattern.compile("(.+?)-([0-9][0-9.]*(?:-M[0-9]+)?)(?:-[a-z].*)?\\.jar");
    private static final List<String> FOR_TESTS = List.of("junit-", "opentest4j-", "apiguardian-api-", "assertj-", "byte-buddy-", "archunit", "slf4j-api-", "openjfx-monocle-", "surefire", "common-java5-", "rt-");

    @Test
    void everythingThatIsShippedIsNamedWithItsVersion() throws IOException {
        String notice = Files.readString(Path.of("src/main/notice/NOTICE"));
        List<String> shipped = Stream.of(System.getProperty("java.class.path").split(File.pathSeparator)).map(entry -> Path.of(entry).getFileName().toString())
                .filter(name -> name.endsWith(".jar") && FOR_TESTS.stream().noneMatch(name::startsWith)).toList();
        assertThat(shipped).hasSizeGreaterThan(5).allSatisfy(file -> {
            Matcher jar = JAR.matcher(file);
            assertThat(jar.matches()).as(file).isTrue();
            String name = jar.group(1).startsWith("javafx-") ? "JavaFX" : jar.group(1);
            assertThat(notice).contains("\n  " + name + " " + jar.group(2) + " ");
        });
    }
}
