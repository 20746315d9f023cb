package cz.paprsek.fx;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** The editor's part of the table of rooms. */
@AnalyzeClasses(packages = "cz.paprsek.fx", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule MODEL_KNOWS_NO_WINDOW = noClasses().that().resideInAPackage("cz.paprsek.fx.model")
            .should().dependOnClassesThat().resideInAnyPackage(
                    "cz.paprsek.fx", "cz.paprsek.fx.view..", "javafx.scene..", "javafx.stage..", "javafx.application..", "javafx.css..");

    @ArchTest
    static final ArchRule VIEWS_KNOW_NO_PROGRAM = noClasses().that().resideInAPackage("cz.paprsek.fx.view..")
            .should().dependOnClassesThat().resideInAPackage("cz.paprsek.fx");

    @ArchTest
    static final ArchRule NO_CYCLES = slices().matching("cz.paprsek.fx.(*)..").should().beFreeOfCycles();

    @ArchTest
    static final ArchRule NO_STATE_IS_STATIC = fields().that().areStatic().should().beFinal();
}
