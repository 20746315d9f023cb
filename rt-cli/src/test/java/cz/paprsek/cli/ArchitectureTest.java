package cz.paprsek.cli;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.Architectures;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import java.util.stream.Collectors;

/** The command line's part of the table of rooms. */
@AnalyzeClasses(packages = "cz.paprsek.cli", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    private static final int MOST_FILES = 25;

    @ArchTest
    static final ArchRule ROOMS = Architectures.layeredArchitecture().consideringOnlyDependenciesInLayers()
            .layer("commands").definedBy("cz.paprsek.cli")
            .layer("db").definedBy("cz.paprsek.cli.db")
            .layer("bench").definedBy("cz.paprsek.cli.bench")
            .layer("output").definedBy("cz.paprsek.cli.output")
            .layer("shard").definedBy("cz.paprsek.cli.shard")
            .layer("plan").definedBy("cz.paprsek.cli.plan")
            .layer("describe").definedBy("cz.paprsek.cli.describe")
            .layer("manual").definedBy("cz.paprsek.cli.manual")
            .layer("input").definedBy("cz.paprsek.cli.input")
            .layer("value").definedBy("cz.paprsek.cli.value")
            .layer("process").definedBy("cz.paprsek.cli.process")
            .whereLayer("commands").mayNotBeAccessedByAnyLayer()
            .whereLayer("db").mayOnlyBeAccessedByLayers("commands")
            .whereLayer("bench").mayOnlyBeAccessedByLayers("commands")
            .whereLayer("describe").mayOnlyBeAccessedByLayers("commands")
            .whereLayer("manual").mayOnlyBeAccessedByLayers("commands")
            .whereLayer("output").mayOnlyBeAccessedByLayers("commands", "db", "bench")
            .whereLayer("plan").mayOnlyBeAccessedByLayers("commands")
            .whereLayer("shard").mayOnlyBeAccessedByLayers("commands", "output", "plan")
            .whereLayer("value").mayOnlyBeAccessedByLayers("commands", "db", "bench", "output", "input", "shard")
            .whereLayer("input").mayOnlyBeAccessedByLayers("commands", "db", "bench", "output");

    @ArchTest
    static final ArchRule NO_CYCLES = slices().assignedFrom(new SliceAssignment() {
        @Override
        public SliceIdentifier getIdentifierOf(JavaClass javaClass) {
            return SliceIdentifier.of(javaClass.getPackageName());
        }

        @Override
        public String getDescription() {
            return "every package";
        }
    }).should().beFreeOfCycles();

    @ArchTest
    static final ArchRule OTHER_PROGRAMS_ARE_STARTED_WHERE_THEY_MAY_BE = noClasses().that()
            .resideOutsideOfPackages("cz.paprsek.cli.bench", "cz.paprsek.cli.process")
            .should().dependOnClassesThat().belongToAnyOf(ProcessBuilder.class, Process.class);

    @ArchTest
    static final ArchRule NO_STATE_IS_STATIC = fields().that().areStatic().should().beFinal();

    @ArchTest
    static void noRoomIsCrowded(JavaClasses all) {
        assertThat(all.stream().filter(JavaClass::isTopLevelClass).collect(Collectors.groupingBy(JavaClass::getPackageName, Collectors.counting())))
                .isNotEmpty().allSatisfy((room, files) -> assertThat(files).as(room).isLessThanOrEqualTo(MOST_FILES));
    }
}
