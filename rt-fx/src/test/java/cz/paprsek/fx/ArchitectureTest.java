package cz.paprsek.fx;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The editor's part of the table of rooms. */
@AnalyzeClasses(packages = "cz.paprsek.fx", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    private static final int MOST_FILES = 25;

    @ArchTest
    static final ArchRule MODEL_KNOWS_NO_WINDOW = classes().that().resideInAPackage("cz.paprsek.fx.model..")
            .should().onlyDependOnClassesThat(resideInAnyPackage("cz.paprsek.fx.model..", "java..", "javafx.beans..", "javafx.util..", "org.jspecify..")
                    .or(resideInAnyPackage("cz.paprsek..").and(resideOutsideOfPackage("cz.paprsek.fx.."))));

    @ArchTest
    static final ArchRule VIEWS_KNOW_NO_PROGRAM = noClasses().that().resideInAPackage("cz.paprsek.fx.view..")
            .should().dependOnClassesThat().resideInAPackage("cz.paprsek.fx");

    /** What is edited is changed through the model of it; where it is kept is the program's business. */
    @ArchTest
    static final ArchRule VIEWS_KNOW_NO_DOCUMENT = noClasses().that().resideInAPackage("cz.paprsek.fx.view..")
            .should().dependOnClassesThat().resideInAPackage("cz.paprsek.fx.model.file");

    @ArchTest
    static final ArchRule VIEWS_TOUCH_NO_HISTORY = noClasses().that().resideOutsideOfPackage("cz.paprsek.fx.model..")
            .should().dependOnClassesThat().haveFullyQualifiedName("cz.paprsek.fx.model.History");

    @ArchTest
    static final ArchRule NO_CYCLES = slices().assignedFrom(new EachPackage()).should().beFreeOfCycles();

    @ArchTest
    static final ArchRule NO_STATE_IS_STATIC = fields().that().areStatic().should().beFinal();

    @Test
    void noPackageIsLargerThanAReaderCanSee() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src"))) {
            Map<Path, List<Path>> packages = files.filter(file -> file.toString().endsWith(".java")).collect(Collectors.groupingBy(Path::getParent));
            assertThat(packages).isNotEmpty().allSatisfy((folder, inside) -> assertThat(inside).hasSizeLessThanOrEqualTo(MOST_FILES));
        }
    }

    /** A slice for each package, those within others too. */
    private static final class EachPackage implements SliceAssignment {
        @Override
        public SliceIdentifier getIdentifierOf(JavaClass javaClass) {
            return SliceIdentifier.of(javaClass.getPackageName());
        }

        @Override
        public String getDescription() {
            return "each package";
        }
    }
}
