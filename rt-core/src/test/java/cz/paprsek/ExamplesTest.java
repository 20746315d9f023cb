package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The small Maven projects that are there to be copied. Maven itself builds them where docs/proofs.md says. */
class ExamplesTest {
    private static final Path EXAMPLES = Path.of("../docs/examples");

    static List<Path> examples() throws IOException {
        try (Stream<Path> all = Files.list(EXAMPLES)) {
            return all.sorted().toList();
        }
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyExampleCompilesWithoutAWarning(Path example, @TempDir Path folder) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter said = new StringWriter();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null); Stream<Path> sources = Files.walk(example.resolve("src/main/java"))) {
            List<Path> java = sources.filter(file -> file.toString().endsWith(".java")).toList();
            assertThat(compiler.getTask(said, files, null, List.of("-Xlint:all,-path,-processing,-options", "-Werror", "--release", "17", "-proc:none", "-d", folder.toString()), null,
                    files.getJavaFileObjectsFromPaths(java)).call()).as(said.toString()).isTrue();
        }
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyExampleIsForThisVersion(Path example) throws IOException {
        Matcher version = Pattern.compile("<version>(.*?)</version>").matcher(Files.readString(Path.of("../pom.xml")));
        assertThat(version.find()).isTrue();
        assertThat(Files.readString(example.resolve("pom.xml"))).contains("<artifactId>rt-core</artifactId>", "<artifactId>" + example.getFileName() + "</artifactId>")
                .containsPattern("<artifactId>rt-(core|bom)</artifactId>\\s+" + version.group());
    }

    /** Maven 3.8 compiles for Java 5 where a project says nothing that its old plugin knows. */
    @ParameterizedTest
    @MethodSource("examples")
    void everyExampleIsCompiledByOldMavenToo(Path example) throws IOException {
        assertThat(Files.readString(example.resolve("pom.xml"))).contains("<maven.compiler.source>17</", "<maven.compiler.target>17</");
    }

    @Test
    void theVersionsToImportAreThoseOfTheBuild() throws IOException {
        Matcher version = Pattern.compile("<version>(.*?)</version>").matcher(Files.readString(Path.of("../pom.xml")));
        assertThat(version.find()).isTrue();
        assertThat(Files.readString(Path.of("bom/pom.xml"))).contains(version.group(), ">rt-core<", ">rt-cli<", ">rt-fx<");
    }

    @Test
    void theManualNamesAll() throws IOException {
        assertThat(Files.readString(Path.of("../docs/library.md"))).contains(examples().stream().map(example -> "(examples/" + example.getFileName() + "/src/main/java/").toList());
    }
}
