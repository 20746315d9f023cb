package cz.paprsek.cli.db;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.Scenes;
import cz.paprsek.cli.input.FileNames;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DbCommandTest {
    @TempDir
    Path folder;

    private Path database;
    private Path ball;

    @BeforeEach
    void writeADatabase() throws IOException {
        database = folder.resolve("db.xml");
        ball = Scenes.ball(folder.resolve("ball.xml"));
        SceneFiles.writeAll(List.of(scene("red one", "one, \"two\"\nthree"), scene("Blue/2", ""), scene("blue:2", "")), database);
    }

    private static Scene scene(String name, String description) {
        Scene empty = Scene.EMPTY.withName(name).withDescription(description).withTags(List.of(name.substring(0, 3).toLowerCase(Locale.ROOT)));
        return empty.withSettings(empty.settings().withSize(8, 4));
    }

    private List<String> names() throws Exception {
        return List.copyOf(SceneFiles.readDatabase(database).names());
    }

    @Test
    void commentsStayWhateverIsDoneToOtherScenes() throws Exception {
        String text = Files.readString(database).replace("  <scene name=\"Blue", "  <!-- blue -->\n  <scene  name=\"Blue").replace("<scene name=\"blue:2\"", "<scene name='blue:2'");
        Files.writeString(database, text + "<!-- end -->\n");
        Run.cli("db", "add", database, ball, "--name", "ball");
        Run.cli("db", "rename", database, "blue:2", "it's");
        Path other = folder.resolve("other.xml");
        SceneFiles.writeAll(List.of(scene("Blue/2", "other")), other);
        Run.cli("db", "merge", database, other, "--replace");
        assertThat(names()).containsExactly("red one", "Blue/2", "it's", "ball");
        Run.cli("db", "remove", database, "ball");
        assertThat(database).hasContent(text.replace("'blue:2'", "'it&apos;s'").replace("scene  name=\"Blue/2\" tags=\"blu\">", "scene name=\"Blue/2\" tags=\"blu\">\n    <description>other</description>")
                + "<!-- end -->\n");
    }

    @Test
    void scenesComeAndGoWithTheirComments() throws Exception {
        String text = """
                <?xml version="1.0" encoding="UTF-8"?>
                <!-- exam 3 -->
                <scene xmlns="urn:paprsek:scene:1">
                  <camera direction='0 0 -1'
                    position="0 0 5.0"/> <!-- TODO -->
                  <?fold?>
                  <background color="red"/>
                </scene>
                """;
        String inside = """
                  <!-- exam 3 -->
                  <scene name="exam">
                    <camera direction='0 0 -1'
                      position="0 0 5.0"/> <!-- TODO -->
                    <?fold?>
                    <background color="red"/>
                  </scene>
                """;
        Path exam = Files.writeString(folder.resolve("exam.xml"), text);
        String before = Files.readString(database);
        assertThat(Run.cli("db", "add", database, exam).code()).isZero();
        assertThat(database).hasContent(before.replace("</database>", inside + "</database>"));
        Path fresh = folder.resolve("fresh.xml");
        Run.cli("db", "init", fresh, "--empty");
        assertThat(Run.cli("db", "merge", fresh, database).code()).isZero();
        assertThat(Files.readString(fresh)).isEqualTo(Files.readString(database));
        assertThat(Run.cli("db", "extract", fresh, "exam", "-o", "-").text()).isEqualTo(text.replace("scene:1\"", "scene:1\" name=\"exam\""));
        Run.cli("db", "extract", fresh, "exam", "-o", folder.resolve("{name}.xml"), "--force");
        assertThat(exam).hasContent(text.replace("scene:1\"", "scene:1\" name=\"exam\""));
    }

    @Test
    void filesWithScenesOfTheSameNameAreNamed() throws Exception {
        Path other = folder.resolve("other.xml");
        SceneFiles.writeAll(List.of(scene("Blue/2", "other"), scene("red one", "other"), scene("new", "")), other);
        Path third = folder.resolve("third.xml");
        SceneFiles.writeAll(List.of(scene("new", "third")), third);
        assertThat(Run.cli("db", "add", folder.resolve("fresh.xml"), other, third).err())
                .startsWith("paprsek: " + other + " and " + third + " have different scenes named \"new\"; give one of them another name\n");
        assertThat(Run.cli("db", "merge", database, other).err()).startsWith("paprsek: " + database + " and " + other
                + " have different scenes named \"Blue/2\", and 1 more of the same names; --keep takes that of the first, --replace that of the other\n");
        assertThat(Run.cli("db", "merge", database, third, other).err()).startsWith("paprsek: " + database + " and " + other + " have");
        assertThat(Run.cli("db", "add", database, third, other, "--replace").err()).startsWith("paprsek: " + third + " and " + other + " have");
        assertThat(Run.cli("db", "add", folder.resolve("fresh.xml"), third, third, Files.copy(third, folder.resolve("copy.xml"))).code()).isZero();
    }

    @Test
    void scenesAreListedInThreeForms() {
        assertThat(Run.cli("db", "list", database).out()).isEqualTo("""
                name     tag  objects  lights  description
                red one  red        0       0  one, "two" three
                Blue/2   blu        0       0
                blue:2   blu        0       0
                """);
        assertThat(Run.cli("db", "list", database, "--csv", "--where", "tag = \"red\"").text()).isEqualTo(
                "name,tag,objects,lights,description\nred one,red,0,0,\"one, \"\"two\"\"\nthree\"\n");
        assertThat(Run.cli("db", "list", database, "--json", "--columns", "name,background,width", "--sort", "name").out()).isEqualTo("""
                {"name":"Blue/2","background":[0,0,0],"width":8}
                {"name":"blue:2","background":[0,0,0],"width":8}
                {"name":"red one","background":[0,0,0],"width":8}
                """);
        assertThat(Run.cli("db", "list", database, "--columns", "name", "--reverse").out().lines()).containsExactly("name", "blue:2", "Blue/2", "red one");
    }

    @Test
    void tablesAreListedAndShown() {
        assertThat(Run.cli("db", "tables", database).out().lines().map(line -> line.split(" +", 2)[0])).startsWith("table", "scene", "camera", "light",
                "material", "object").contains("sphere", "torus", "difference");
        assertThat(Run.cli("db", "show", "camera", database, "--scenes", "name like \"blue%\"", "--columns", "scene,position.z", "--csv").text())
                .isEqualTo("scene,position.z\nBlue/2,5\nblue:2,5\n");
        assertThat(Run.cli("db", "find", ball, "--where", "radius > 0.5").out().lines()).containsExactly(
                "table   scene  path", "sphere  ball   sphere#1");
    }

    @Test
    void scenesAreAddedRenamedMergedAndRemoved() throws Exception {
        Path fresh = folder.resolve("fresh.xml");
        assertThat(Run.cli("db", "add", fresh, ball, "--name", "my ball", "--tag", "round").err()).isEqualTo(fresh + ": 1 scene added\n");
        assertThat(SceneFiles.readDatabase(fresh).get("my ball").tags()).containsExactly("round");
        assertThat(Run.cli("db", "merge", database, fresh).err()).isEqualTo(database + ": 4 scenes, 1 of them new\n");
        assertThat(Run.cli("db", "rename", database, "my ball", "ball").code()).isZero();
        assertThat(names()).containsExactly("red one", "Blue/2", "blue:2", "ball");
        assertThat(Run.cli("db", "add", database, ball).err()).startsWith("paprsek: " + database + " and " + ball
                + " have different scenes named \"ball\"; --replace takes that of " + ball + ", --name gives it another name\n");
        assertThat(Run.cli("db", "add", database, ball, "--replace", "--quiet").err()).isEmpty();
        assertThat(SceneFiles.readDatabase(database).get("ball").tags()).isEmpty();
        assertThat(Run.cli("db", "remove", database, "--where", "exists(sphere) or tag = \"red\"").err())
                .isEqualTo(database + ": 2 scenes removed: red one, ball\n");
        assertThat(names()).containsExactly("Blue/2", "blue:2");
    }

    @Test
    void scenesAreExtractedToFilesThatAreNotOverwritten() throws Exception {
        Path out = folder.resolve("out");
        assertThat(Run.cli("db", "extract", database, "--where", "tag = \"blu\"", "-o", out + "/").code()).isZero();
        assertThat(out.toFile().list()).containsExactlyInAnyOrder("Blue-2.xml", "blue-2-2.xml");
        assertThat(SceneFiles.read(out.resolve("blue-2-2.xml")).name()).isEqualTo("blue:2");
        assertThat(Run.cli("db", "extract", database, "blue:2", "-o", "-").text()).isEqualTo(Files.readString(out.resolve("blue-2-2.xml")));
        assertThat(Run.cli("db", "extract", database, "Blue/2", "-o", out).err()).contains("Blue-2.xml exists already; --force overwrites it");
        assertThat(Run.cli("db", "extract", database, "Blue/2", "-o", out, "--force").code()).isZero();
        assertThat(Run.cli("db", "extract", database, "Blue/2", "red one", "-o", "x.xml").err()).contains("2 scenes do not fit into x.xml");
    }

    /** Else a scene that was taken to another folder could not be rendered there. */
    @Test
    void picturesGoAlongWhereScenesAreTaken() throws IOException {
        Path here = Files.createDirectories(folder.resolve("here/pics"));
        Run.cli("render", ball, "-o", here.resolve("a.png"), "-q");
        Path tiled = Scenes.scene(here.resolveSibling("tiled.xml"), "<rectangle min='-1 -1' max='1 1'><material><image file='pics/a.png'/></material></rectangle>");
        Path there = Files.createDirectory(folder.resolve("there"));
        assertThat(Run.cli("db", "add", there.resolve("db.xml"), tiled).err()).isEqualTo(there.resolve("db.xml") + ": 1 scene added\n");
        assertThat(there.resolve("pics/a.png")).hasSameBinaryContentAs(here.resolve("a.png"));
        assertThat(Run.cli("render", there.resolve("db.xml"), "-o", folder.resolve("out.png"), "-q").code()).isZero();
        assertThat(Run.cli("db", "extract", there.resolve("db.xml"), "ball", "-o", folder.resolve("third/t.xml")).code()).isZero();
        assertThat(Run.cli("validate", folder.resolve("third/t.xml"), "-q").code()).isZero();
        Path fourth = Files.createDirectory(folder.resolve("fourth"));
        Run.cli("db", "init", fourth.resolve("db.xml"), "--empty");
        assertThat(Run.cli("db", "merge", fourth.resolve("db.xml"), there.resolve("db.xml")).code()).isZero();
        assertThat(fourth.resolve("pics/a.png")).hasSameBinaryContentAs(here.resolve("a.png"));
    }

    @Test
    void aPictureThatIsMissingIsToldAndAnotherOfItsNameIsNotOverwritten() throws IOException {
        Path scene = Scenes.scene(folder.resolve("tiled.xml"), "<rectangle min='-1 -1' max='1 1'><material><image file='a.png'/></material></rectangle>");
        Path there = Files.createDirectory(folder.resolve("there"));
        Path target = there.resolve("db.xml");
        assertThat(Run.cli("db", "add", target, scene)).matches(run -> run.code() == 0
                && run.err().startsWith(target + ": warning: scene \"ball\": \"a.png\": there is no such file beside the scene; it is not taken along\n"));
        Files.writeString(folder.resolve("a.png"), "one");
        Files.writeString(there.resolve("a.png"), "other");
        byte[] before = Files.readAllBytes(target);
        Run refused = Run.cli("db", "add", target, scene, "--name", "again");
        assertThat(refused.code()).isEqualTo(1);
        assertThat(refused.err()).isEqualTo(target + ": there is another picture a.png beside it; give one of them another name\n");
        assertThat(target).hasBinaryContent(before);
        assertThat(there.resolve("a.png")).hasContent("other");
    }

    @Test
    void aNewDatabaseHasExamplesOrNothing() throws Exception {
        Path fresh = folder.resolve("fresh.xml");
        assertThat(Run.cli("db", "init", fresh).code()).isZero();
        assertThat(SceneFiles.readDatabase(fresh).names()).contains("Test scene").hasSizeGreaterThan(20);
        assertThat(Run.cli("db", "init", fresh, "--empty").err()).contains("exists already; --force overwrites it");
        assertThat(Run.cli("db", "init", fresh, "--empty", "--force").code()).isZero();
        assertThat(SceneFiles.readDatabase(fresh).size()).isZero();
    }

    @Test
    void theScenesOfADatabaseThatMatchAreRenderedUnderTheirNames() throws IOException {
        Path out = folder.resolve("out");
        Run run = Run.cli("render", database, ball, "--where", "not tag = \"red\"", "-o", out + "/{name}.png", "--quiet", "--json");
        assertThat(run.code()).isZero();
        assertThat(run.out().lines()).hasSize(3).allMatch(line -> line.contains("\"outcome\":\"done\""));
        assertThat(out.toFile().list()).containsExactlyInAnyOrder("Blue-2.png", "blue-2-2.png", "ball.png");
        assertThat(Run.cli("render", database, "--where", "lights > 9").err()).contains("no scene matches lights > 9");
        assertThat(Run.cli("render", database, "--where", "lihgts > 9").err()).contains("--where, character 1: there is no column \"lihgts\"");
        assertThat(Run.cli("render", database, "-o", out + "/", "--quiet").code()).isZero();
        assertThat(out.resolve("red-one.png")).exists();
    }

    @Test
    void twoWhoChangeADatabaseAtOnceLoseNothing() throws Exception {
        List<Integer> codes = IntStream.range(0, 12).parallel()
                .mapToObj(i -> Run.cli("db", "add", database, ball, "--name", "ball " + i).code()).toList();
        assertThat(codes).containsOnly(0);
        assertThat(names()).hasSize(15);
        assertThat(folder.toFile().list()).containsExactlyInAnyOrder("db.xml", "ball.xml");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "db                                    | say what to do: list, tables, show, find, add, extract, remove, rename, merge, init",
        "db lsit DB                            | there is no command \"lsit\"; did you mean \"list\"?",
        "db show spere DB                      | there is no table \"spere\"; did you mean \"sphere\"?",
        "db list DB --columns nam              | there is no column \"nam\" in scene; did you mean \"name\"?",
        "db list DB --sort nam                 | there is no column \"nam\" in scene",
        "db list DB --csv --json               | --csv and --json exclude each other",
        "db find DB --where raduis=1           | there is no column \"raduis\" in light; did you mean \"radius\"?",
        "db remove DB                          | say which scenes: either their names, or --where with a filter",
        "db remove DB red --where lights=0     | say which scenes: either their names, or --where with a filter",
        "db remove DB Blue/3                   | there is no scene named \"Blue/3\"; did you mean \"Blue/2\"?",
        "db remove DB --where lights=7         | no scene matches lights=7",
        "db rename DB Blue/2 blue:2            | there is already a scene named \"blue:2\"",
        "db merge DB DB --keep --replace       | --keep and --replace exclude each other",
        "db add DB DB --name x                 | --name is for one scene, but there are 3",
    })
    void wrongUsageIsExplainedInOneSentence(String line, String sentence) throws Exception {
        String before = Files.readString(database);
        Run run = Run.cli((Object[]) line.trim().replace("DB", database.toString()).split(" "));
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains(sentence).contains("--help'.").hasLineCount(2);
        assertThat(database).hasContent(before);
    }

    @Test
    void aMissingOrBrokenFileIsABadScene() throws IOException {
        Path none = folder.resolve("none.xml");
        for (String command : List.of("list", "tables", "remove")) {
            Run run = command.equals("remove") ? Run.cli("db", command, none, "x") : Run.cli("db", command, none);
            assertThat(run.code()).isEqualTo(3);
            assertThat(run.err()).isEqualTo(none + ": no such file\n");
        }
        Path broken = Scenes.broken(folder.resolve("broken.xml"));
        assertThat(Run.cli("db", "list", broken).err()).startsWith(broken + ":2:").hasLineCount(2);
        assertThat(Run.cli("db", "merge", database, broken).code()).isEqualTo(3);
        for (List<Object> change : List.<List<Object>>of(List.of("rename", ball, "ball", "x"), List.of("add", ball, ball), List.of("remove", ball, "ball"), List.of("merge", ball, database))) {
            Run run = Run.cli(Stream.concat(Stream.of("db"), change.stream()).toArray());
            assertThat(run.err()).isEqualTo(ball + ": this is a scene, not a database; it can be added to one\n");
            assertThat(run.code()).isEqualTo(3);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"list", "tables", "show", "find", "add", "extract", "remove", "rename", "merge", "init"})
    void everyCommandExplainsItself(String command) {
        Run run = Run.cli("db", command, "--help");
        assertThat(run.code()).isZero();
        assertThat(run.out()).contains("Usage: paprsek db " + command, "Example", "Exit codes:").doesNotContain("%%");
        assertThat(run.out().lines()).allMatch(line -> line.length() <= 100);
        assertThat(Run.cli("db", "--help").out()).contains(command, "A filter compares").doesNotContain("%%");
    }

    @Test
    void namesAreMadeFitForFilesOnEverySystem() {
        assertThat(FileNames.of(List.of("a b", "a/b", "A:B", "..", "con", "žluť*", "x".repeat(300), "plain-1.2"))).isEqualTo(Map.of(
                "a b", "a-b", "a/b", "a-b-2", "A:B", "A-B-3", "..", "scene", "con", "scene-con", "žluť*", "žluť", "x".repeat(300), "x".repeat(80),
                "plain-1.2", "plain-1.2"));
    }
}
