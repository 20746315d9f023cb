package cz.paprsek;

import static com.tngtech.archunit.core.domain.JavaCall.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.equivalentTo;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackages;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameMatching;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.Architectures;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The table of rooms: which package may use which. */
@AnalyzeClasses(packages = "cz.paprsek", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    private static final long MOST_FILES = 25;

    @ArchTest
    static final ArchRule ROOMS = Architectures.layeredArchitecture().consideringOnlyDependenciesInLayers()
            .layer("io").definedBy("cz.paprsek.io")
            .layer("math").definedBy("cz.paprsek.math")
            .layer("attribute").definedBy("cz.paprsek.attribute")
            .layer("tree").definedBy("cz.paprsek.tree")
            .layer("list").definedBy("cz.paprsek.list")
            .layer("material").definedBy("cz.paprsek.material")
            .layer("ray").definedBy("cz.paprsek.ray")
            .layer("shape").definedBy("cz.paprsek.shape..")
            .layer("scene").definedBy("cz.paprsek.scene..")
            .layer("query").definedBy("cz.paprsek.query..")
            .layer("image").definedBy("cz.paprsek.image..")
            .layer("asset").definedBy("cz.paprsek.asset")
            .layer("render").definedBy(resideInAPackage("cz.paprsek.render..").and(resideOutsideOfPackage("cz.paprsek.render.explain..")))
            .layer("explain").definedBy("cz.paprsek.render.explain")
            .layer("worked").definedBy("cz.paprsek.render.explain.text")
            .layer("words").definedBy("cz.paprsek.words")
            .layer("drawing").definedBy("cz.paprsek.drawing")
            .layer("sheet").definedBy("cz.paprsek.sheet..")
            .layer("xml").definedBy(resideInAPackage("cz.paprsek.xml..").and(resideOutsideOfPackage("cz.paprsek.xml.text")))
            .layer("text").definedBy("cz.paprsek.xml.text")
            .layer("pov").definedBy("cz.paprsek.pov")
            .layer("format").definedBy("cz.paprsek.format..")
            .layer("origin").definedBy("cz.paprsek.origin")
            .layer("standard").definedBy("cz.paprsek.standard")
            .layer("warning").definedBy("cz.paprsek.warning")
            .layer("teach").definedBy("cz.paprsek.teach..")
            .layer("lesson").definedBy("cz.paprsek.lesson")
            .whereLayer("origin").mayNotBeAccessedByAnyLayer()
            .whereLayer("standard").mayNotBeAccessedByAnyLayer()
            .whereLayer("warning").mayNotBeAccessedByAnyLayer()
            .whereLayer("teach").mayNotBeAccessedByAnyLayer()
            .whereLayer("lesson").mayNotBeAccessedByAnyLayer()
            .whereLayer("io").mayOnlyBeAccessedByLayers("query", "image", "asset", "worked", "xml", "pov", "format", "teach", "lesson")
            .whereLayer("list").mayOnlyBeAccessedByLayers("scene", "render")
            .whereLayer("tree").mayOnlyBeAccessedByLayers("shape", "render")
            .whereLayer("attribute").mayOnlyBeAccessedByLayers("material", "shape", "scene", "query", "worked", "words", "xml", "pov", "warning")
            .whereLayer("material").mayOnlyBeAccessedByLayers("shape", "scene", "query", "image", "render", "explain", "worked", "drawing", "sheet", "xml", "pov", "standard", "warning", "format", "origin", "teach", "lesson")
            .whereLayer("ray").mayOnlyBeAccessedByLayers("material", "shape", "scene", "render")
            .whereLayer("shape").mayOnlyBeAccessedByLayers("scene", "query", "render", "explain", "worked", "words", "drawing", "sheet", "xml", "pov", "standard", "warning", "format", "teach", "lesson")
            .whereLayer("scene").mayOnlyBeAccessedByLayers("query", "render", "explain", "worked", "words", "drawing", "sheet", "xml", "pov", "standard", "warning", "format", "origin", "teach", "lesson")
            .whereLayer("query").mayOnlyBeAccessedByLayers("lesson")
            .whereLayer("image").mayOnlyBeAccessedByLayers("asset", "render", "drawing", "pov", "origin", "format", "teach", "lesson")
            .whereLayer("asset").mayOnlyBeAccessedByLayers("render", "format", "xml", "lesson")
            .whereLayer("explain").mayOnlyBeAccessedByLayers("render", "worked", "drawing", "sheet", "lesson")
            .whereLayer("worked").mayOnlyBeAccessedByLayers("drawing", "sheet", "lesson")
            .whereLayer("words").mayOnlyBeAccessedByLayers("worked", "drawing", "sheet", "teach")
            .whereLayer("sheet").mayNotBeAccessedByAnyLayer()
            .whereLayer("drawing").mayOnlyBeAccessedByLayers("sheet")
            .whereLayer("render").mayOnlyBeAccessedByLayers("drawing", "sheet", "pov", "origin", "lesson")
            .whereLayer("xml").mayOnlyBeAccessedByLayers("origin", "lesson", "sheet")
            .whereLayer("text").mayOnlyBeAccessedByLayers("xml")
            .whereLayer("pov").mayNotBeAccessedByAnyLayer()
            .whereLayer("format").mayOnlyBeAccessedByLayers("render");

    @ArchTest
    static final ArchRule MATH_KNOWS_NOTHING = noClasses().that().resideInAPackage("cz.paprsek.math")
            .should().dependOnClassesThat().resideInAnyPackage("cz.paprsek.material", "cz.paprsek.ray", "cz.paprsek.shape..", "cz.paprsek.scene", "cz.paprsek.io");

    @ArchTest
    static final ArchRule ATTRIBUTES_KNOW_NOBODY = noClasses().that().resideInAPackage("cz.paprsek.attribute")
            .should().dependOnClassesThat(resideInAPackage("cz.paprsek..").and(resideOutsideOfPackage("cz.paprsek.attribute")));

    @ArchTest
    static final ArchRule TREE_SEES_ONLY_MATH = noClasses().that().resideInAPackage("cz.paprsek.tree")
            .should().dependOnClassesThat(resideInAPackage("cz.paprsek..").and(resideOutsideOfPackages("cz.paprsek.tree", "cz.paprsek.math")));

    @ArchTest
    static final ArchRule TEXT_SEES_ONLY_MATH = noClasses().that().resideInAPackage("cz.paprsek.text")
            .should().dependOnClassesThat(resideInAPackage("cz.paprsek..").and(resideOutsideOfPackages("cz.paprsek.text", "cz.paprsek.math")));

    /** The plain tracer is an answer of its own: of shapes it knows what is written down, not how the renderer meets them. */
    @ArchTest
    static final ArchRule PLAIN_TRACER_SHARES_NOTHING_WITH_THE_RENDERER = noClasses().that().resideInAPackage("cz.paprsek.teach..")
            .should().dependOnClassesThat().resideInAnyPackage("cz.paprsek.render..", "cz.paprsek.shape.placed", "cz.paprsek.ray", "cz.paprsek.tree");

    @ArchTest
    static final ArchRule NO_CYCLES = slices().matching("cz.paprsek.(**)").should().beFreeOfCycles();

    /** Of the rooms of the renderer, each sees only those before it. */
    @ArchTest
    static final ArchRule RENDER_ROOMS = Architectures.layeredArchitecture().consideringOnlyDependenciesInLayers()
            .layer("explain").definedBy("cz.paprsek.render.explain")
            .layer("film").definedBy("cz.paprsek.render.film")
            .layer("lanes").definedBy("cz.paprsek.render.lanes")
            .layer("light").definedBy("cz.paprsek.render.light")
            .layer("glow").definedBy("cz.paprsek.render.glow")
            .layer("eye").definedBy("cz.paprsek.render.eye")
            .layer("sample").definedBy("cz.paprsek.render.sample")
            .layer("texture").definedBy("cz.paprsek.render.texture")
            .layer("hull").definedBy("cz.paprsek.render.hull")
            .layer("buffer").definedBy("cz.paprsek.render.buffer")
            .layer("surface").definedBy("cz.paprsek.render.surface")
            .layer("integrate").definedBy("cz.paprsek.render.integrate")
            .layer("mode").definedBy("cz.paprsek.render.mode")
            .layer("account").definedBy("cz.paprsek.render.account")
            .layer("show").definedBy("cz.paprsek.render.show")
            .layer("work").definedBy("cz.paprsek.render.work")
            .layer("render").definedBy("cz.paprsek.render")
            .layer("live").definedBy("cz.paprsek.render.live")
            .whereLayer("explain").mayOnlyBeAccessedByLayers("integrate", "account", "render")
            .whereLayer("film").mayOnlyBeAccessedByLayers("integrate", "show", "work", "render")
            .whereLayer("lanes").mayOnlyBeAccessedByLayers("light", "eye", "surface", "integrate")
            .whereLayer("light").mayOnlyBeAccessedByLayers("glow", "surface", "integrate", "account", "show", "render")
            .whereLayer("glow").mayOnlyBeAccessedByLayers("surface", "integrate", "render")
            .whereLayer("eye").mayOnlyBeAccessedByLayers("integrate", "account", "show", "render")
            .whereLayer("sample").mayOnlyBeAccessedByLayers("light", "integrate", "account", "show", "render")
            .whereLayer("hull").mayOnlyBeAccessedByLayers("buffer", "surface")
            .whereLayer("buffer").mayOnlyBeAccessedByLayers("light", "surface", "integrate")
            .whereLayer("texture").mayOnlyBeAccessedByLayers("glow", "surface", "render")
            .whereLayer("surface").mayOnlyBeAccessedByLayers("integrate", "account", "show", "render")
            .whereLayer("integrate").mayOnlyBeAccessedByLayers("account", "show", "work", "render")
            .whereLayer("account").mayOnlyBeAccessedByLayers("show", "render")
            .whereLayer("work").mayOnlyBeAccessedByLayers("render")
            .whereLayer("mode").mayOnlyBeAccessedByLayers("show", "render")
            .whereLayer("show").mayOnlyBeAccessedByLayers("render")
            .whereLayer("render").mayOnlyBeAccessedByLayers("live")
            .whereLayer("live").mayNotBeAccessedByAnyLayer();

    @ArchTest
    static final ArchRule NO_CYCLES_AMONG_RENDER_ROOMS = slices().matching("cz.paprsek.render.(*)..").should().beFreeOfCycles();

    /** Of the rooms of scene files, each sees only those before it. */
    @ArchTest
    static final ArchRule XML_ROOMS = Architectures.layeredArchitecture().consideringOnlyDependenciesInLayers()
            .layer("format").definedBy("cz.paprsek.xml.format")
            .layer("text").definedBy("cz.paprsek.xml.text")
            .layer("quick").definedBy("cz.paprsek.xml.quick")
            .layer("bind").definedBy("cz.paprsek.xml.bind")
            .layer("write").definedBy("cz.paprsek.xml.write")
            .layer("recipe").definedBy("cz.paprsek.xml.recipe")
            .layer("xml").definedBy("cz.paprsek.xml")
            .whereLayer("format").mayOnlyBeAccessedByLayers("quick", "bind", "write", "recipe", "xml")
            .whereLayer("text").mayOnlyBeAccessedByLayers("write", "recipe", "xml")
            .whereLayer("quick").mayOnlyBeAccessedByLayers("xml")
            .whereLayer("bind").mayOnlyBeAccessedByLayers("xml")
            .whereLayer("write").mayOnlyBeAccessedByLayers("xml")
            .whereLayer("recipe").mayOnlyBeAccessedByLayers("xml")
            .whereLayer("xml").mayNotBeAccessedByAnyLayer();

    @ArchTest
    static final ArchRule JAXB_ONLY_IN_BIND = noClasses().that().resideOutsideOfPackage("cz.paprsek.xml.bind")
            .should().dependOnClassesThat().resideInAnyPackage("jakarta.xml..");

    @ArchTest
    static final ArchRule OTHER_XML_ONLY_IN_XML = noClasses().that().resideOutsideOfPackages("cz.paprsek.xml", "cz.paprsek.xml.bind", "cz.paprsek.xml.mistake")
            .should().dependOnClassesThat().resideInAnyPackage("javax.xml..", "org.xml..");

    @ArchTest
    static final ArchRule PICTURES_ONLY_IN_IMAGE = noClasses().that().resideOutsideOfPackage("cz.paprsek.image")
            .should().dependOnClassesThat().resideInAnyPackage("java.awt..", "javax.imageio..", "javafx..");

    @ArchTest
    static final ArchRule FILES_ONLY_AT_THE_BORDER = noClasses().that()
            .resideInAnyPackage("cz.paprsek.math", "cz.paprsek.tree", "cz.paprsek.material", "cz.paprsek.ray", "cz.paprsek.shape..", "cz.paprsek.scene", "cz.paprsek.query", "cz.paprsek.render..")
            .should().dependOnClassesThat().resideInAnyPackage("java.nio..");

    @ArchTest
    static final ArchRule NO_OTHER_PROGRAM_IS_STARTED = noClasses().should().dependOnClassesThat().belongToAnyOf(ProcessBuilder.class, Process.class);

    @ArchTest
    static final ArchRule NO_STATE_IS_STATIC = fields().that().areStatic().should().beFinal();

    /** What may differ from JDK to JDK in the last bit; {@link StrictMath} has the same functions, and they may not. */
    @ArchTest
    static final ArchRule ARITHMETIC_IS_THE_SAME_EVERYWHERE = noClasses().should().callMethodWhere(
            target(owner(equivalentTo(Math.class)))
                    .and(target(nameMatching("a?(sin|cos|tan)h?|atan2|exp|expm1|log|log10|log1p|pow|cbrt|hypot"))));

    /** In all modules: this one is the first that is built. */
    @Test
    void noRoomIsLargerThanAReaderCanSee() throws IOException {
        Map<Path, Long> rooms = new TreeMap<>();
        for (String module : List.of("rt-core", "rt-cli", "rt-cli/spark", "rt-fx")) {
            try (Stream<Path> files = Files.walk(Path.of("..", module, "src", "main", "java"))) {
                rooms.putAll(files.filter(file -> file.toString().endsWith(".java")).collect(Collectors.groupingBy(Path::getParent, Collectors.counting())));
            }
        }
        assertThat(rooms).hasSizeGreaterThan(50).allSatisfy((room, count) -> assertThat(count).isLessThanOrEqualTo(MOST_FILES));
    }
}
