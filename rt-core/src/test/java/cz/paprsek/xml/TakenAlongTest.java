package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.scene.SceneDatabase.Clash;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the text of a scene looks like that is taken from one file into another. */
class TakenAlongTest {
    private static final String EMPTY = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<database xmlns=\"urn:paprsek:scene:1\">\n</database>\n";
    private static final String EXAM = """
            <?xml version="1.0" encoding="UTF-8"?>
            <!-- exam 3, do not
                 change the light! -->
            <scene xmlns="urn:paprsek:scene:1">
              <sphere position='1
            2 3' radius="+1.50"/> <!-- in cm -->
              <?fold yes
            ?>
              <camera direction='0 0 -1' position="0 0 5.0"/>

              <description>one
              two</description>
              <background color="red"/>
            </scene>
            """;
    private static final String IN_DATABASE = """
              <!-- exam 3, do not
                   change the light! -->
              <scene name="exam">
                <sphere position='1
            2 3' radius="+1.50"/> <!-- in cm -->
                <?fold yes
            ?>
                <camera direction='0 0 -1' position="0 0 5.0"/>

                <description>one
              two</description>
                <background color="red"/>
              </scene>
            """;

    @TempDir
    Path folder;

    private OriginalText text(String xml) throws Exception {
        return OriginalText.read(Files.writeString(folder.resolve("from.xml"), xml));
    }

    private String taken(String into, OriginalText from, String name) throws Exception {
        Path file = Files.writeString(folder.resolve("db.xml"), into);
        SceneDatabase more = SceneDatabase.of(from.contents().scenes().stream().map(scene -> scene.withName(name)).toList());
        DatabaseFile saved = DatabaseFile.update(file, database -> database.merge(more, Clash.REPLACE), from);
        assertThat(DatabaseFile.open(file).database()).isEqualTo(saved.database());
        return Files.readString(file);
    }

    @Test
    void commentsInstructionsOrderAndWordsComeAlongIntoADatabaseAndBack() throws Exception {
        String database = EMPTY.replace("</", IN_DATABASE + "</");
        assertThat(taken(EMPTY, text(EXAM), "exam")).isEqualTo(database);
        Path file = folder.resolve("new.xml");
        DatabaseFile.create(file).save(SceneDatabase.EMPTY.plus(text(EXAM).contents().scenes().get(0).withName("exam")), text(EXAM));
        assertThat(file).hasContent(database);
        OriginalText theirs = text(database);
        SceneFile alone = SceneFile.create(folder.resolve("alone.xml"), theirs.contents().scenes().get(0), theirs);
        assertThat(alone.path()).hasContent(EXAM.replace("scene:1\"", "scene:1\" name=\"exam\""));
    }

    @Test
    void whatHasChangedSinceKeepsTheRestOfItsText() throws Exception {
        OriginalText theirs = text(EMPTY.replace("</", IN_DATABASE + "</"));
        Scene scene = theirs.contents().scenes().get(0);
        SceneFile alone = SceneFile.create(folder.resolve("alone.xml"), scene.withDescription("new"), theirs);
        assertThat(alone.path()).hasContent(EXAM.replace("scene:1\"", "scene:1\" name=\"exam\"").replace("one\n  two", "new"));
        assertThat(alone.save(scene).path()).hasContent(EXAM.replace("scene:1\"", "scene:1\" name=\"exam\""));
    }

    @Test
    void prefixesAndNamespacesAreThoseOfTheFileItIsIn() throws Exception {
        String prefixed = EXAM.replaceAll("<(/?)(?=[a-z])", "<$1p:").replace("xmlns=", "xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' xmlns:p=")
                .replace("<p:sphere", "<p:sphere xsi:schemaLocation='a b'");
        String declared = " xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance'";
        assertThat(taken(EMPTY, text(prefixed), "exam")).isEqualTo(EMPTY.replace("</", IN_DATABASE.replace("\"exam\">", "\"exam\"" + declared + ">")
                .replace("<sphere", "<sphere xsi:schemaLocation='a b'") + "</"));
        String inside = IN_DATABASE.replaceAll("<(/?)(?=[a-z])", "<$1q:");
        String other = EMPTY.replaceAll("<(/?)(?=[a-z])", "<$1q:").replace("xmlns=", "xmlns:q=");
        assertThat(taken(other, text(EXAM), "exam")).isEqualTo(other.replace("</", inside + "</"));
        OriginalText theirs = text(other.replace("</", inside.replace("<q:sphere", "<q:sphere xsi:schemaLocation='a b'") + "</")
                .replace("<q:database", "<q:database" + declared));
        SceneFile alone = SceneFile.create(folder.resolve("alone.xml"), theirs.contents().scenes().get(0), theirs);
        assertThat(Files.readString(alone.path())).contains("\n<q:scene xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xmlns:q=\"urn:paprsek:scene:1\" name=\"exam\">\n"
                + "  <q:sphere xsi:schemaLocation='a b' position");
    }

    @Test
    void commentsOfWhatReplacesAnotherComeInPlaceOfThoseOfTheOther() throws Exception {
        String old = EMPTY.replace("</", "  <!-- first -->\n\n  <!-- old -->\n  <scene name=\"exam\"><camera position=\"0 0 5\" direction=\"0 0 -1\"/></scene> <!-- o -->\n  <!-- last -->\n</");
        String now = taken(old, text(EXAM), "exam");
        assertThat(now).isEqualTo(EMPTY.replace("</", "  <!-- first -->\n\n" + IN_DATABASE.replace("</scene>", "</scene> <!-- o -->") + "  <!-- last -->\n</"));
        assertThat(taken(now, text(EXAM), "exam")).isEqualTo(now);
        String bare = EXAM.replaceAll("(?s)<!-- exam.*?-->\n", "");
        assertThat(taken(now, text(bare.replace("1.50", "1.60")), "exam")).isEqualTo(now.replace("1.50", "1.60"));
        assertThat(taken(now, text(EXAM.replace("1.50", "1.60")), "exam")).isEqualTo(now.replace("1.50", "1.60"));
    }

    @Test
    void linesEndAsInTheFileItIsInWhateverTheEncodings() throws Exception {
        String windows = EMPTY.replace("\n", "\r\n").replace("UTF-8", "windows-1250");
        Path file = Files.write(folder.resolve("db.xml"), windows.getBytes(Charset.forName("windows-1250")));
        String czech = EXAM.replace("in cm", "v metrech: dvě, ∞");
        OriginalText from = OriginalText.read(Files.write(folder.resolve("from.xml"), ("\uFEFF" + czech.replace("UTF-8", "UTF-16")).getBytes(StandardCharsets.UTF_16LE)));
        DatabaseFile.update(file, database -> database.plus(from.contents().scenes().get(0).withName("exam")), from);
        assertThat(Files.readString(file, Charset.forName("windows-1250"))).isEqualTo(windows.replace("</", IN_DATABASE.replace("in cm", "v metrech: dvě, &#8734;")
                .replace("\n", "\r\n") + "</"));
    }

    @Test
    void whatIsAroundASceneOfItsOwnGoesWithIt() throws Exception {
        String around = EXAM.replace("?>\n<!--", "?>\n\n<?style a?>\n\n<!--").replace("</scene>\n", "</scene>\n\n<!-- end -->\n<?end?>\n");
        String database = taken(EMPTY, text(around), "exam");
        assertThat(database).isEqualTo(EMPTY.replace("</", "  <?style a?>\n" + IN_DATABASE.replace("</scene>", "</scene> <!-- end --> <?end?>") + "</"));
        OriginalText theirs = text(database);
        Scene scene = theirs.contents().scenes().get(0);
        assertThat(Files.readString(SceneFile.create(folder.resolve("alone.xml"), scene, theirs).path()))
                .contains("?>\n<?style a?>\n<!-- exam").endsWith("</scene> <!-- end --> <?end?>\n");
    }

    /** A scene of a file, its line ends and indents aside. */
    private static String scene(String file, String name) {
        return Arrays.stream(file.replaceAll("\\s+", " ").split("(?=<scene)")).map(scene -> scene.replaceAll("(</scene ?>).*", "$1"))
                .filter(scene -> scene.substring(0, scene.indexOf('>')).contains(name)).findFirst().orElseThrow();
    }

    @Test
    void randomScenesComeAlongWordByWord() throws Exception {
        for (int seed = 0; seed < 25; seed++) {
            List<Scene> scenes = new ArrayList<>();
            for (int i = 0; i < 3; i++) {
                scenes.add(RandomScenes.of(seed + i).withName("scene " + i));
            }
            String theirs = RandomLayout.of(SceneFiles.formatAll(scenes), seed);
            OriginalText from = text(theirs);
            String database = RandomLayout.of(SceneFiles.formatAll(List.of(Scene.EMPTY.withName("mine"))), seed + 1);
            Path file = Files.writeString(folder.resolve("db.xml"), database);
            DatabaseFile.update(file, mine -> mine.plus(from.contents().scenes()), from);
            assertThat(DatabaseFile.open(file).database().scenes().subList(1, 4)).as("seed %d", seed).isEqualTo(from.contents().scenes());
            assertThat(scene(Files.readString(file), "scene 1")).as("seed %d", seed).isEqualTo(scene(theirs, "scene 1"));
        }
    }
}
