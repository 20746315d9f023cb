package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.scene.SceneDatabase.Clash;
import cz.paprsek.xml.text.FileText;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a database's file looks like after a change. */
class DatabaseTextTest {
    private static final String CAMERA = "<camera direction='0 0 -1' position='0 1 5' />";
    private static final String TEXT = """
            <!-- mine -->
            <database xmlns="urn:paprsek:scene:1">

              <!-- first -->
              <scene name='one'>%1$s</scene> <!-- good -->
              <scene tags="a  b"
                     name="two">
                <!-- inside -->
                %1$s
              </scene>
            \t<scene name='three'>%1$s</scene>
              <!-- last -->
            </database><!-- end -->
            """.formatted(CAMERA);

    @TempDir
    Path folder;

    private String changed(String text, UnaryOperator<SceneDatabase> change) throws Exception {
        Path file = Files.writeString(folder.resolve("db.xml"), text);
        DatabaseFile opened = DatabaseFile.open(file);
        SceneDatabase wanted = change.apply(opened.database());
        DatabaseFile saved = DatabaseFile.update(file, change);
        assertThat(DatabaseFile.open(file).database()).isEqualTo(wanted).isEqualTo(saved.database());
        String result = Files.readString(file);
        saved.save(opened.database());
        assertThat(file).as("changed back").hasContent(text);
        return result;
    }

    @Test
    void namesTagsAndDescriptionsChangeWhereTheyStand() throws Exception {
        assertThat(changed(TEXT, database -> database.rename("two", "deux"))).isEqualTo(TEXT.replace("\"two\"", "\"deux\""));
        assertThat(changed(TEXT, database -> database.replace("two", database.get("two").withTags(List.of("c"))))).isEqualTo(TEXT.replace("a  b", "c"));
        assertThat(changed(TEXT, database -> database.replace("two", database.get("two").withDescription("new")))).isEqualTo(
                TEXT.replace("    <!-- inside -->", "    <description>new</description>\n    <!-- inside -->"));
    }

    @Test
    void scenesComeAtTheEndAndGoWithTheirLines() throws Exception {
        Scene four = Scene.EMPTY.withName("four");
        String expected = "three'>" + CAMERA + "</scene>\n\t<scene name=\"four\">\n\t  <camera position=\"0 1 5\" direction=\"0 0 -1\"/>\n\t</scene>";
        assertThat(changed(TEXT, database -> database.plus(four))).isEqualTo(TEXT.replace("three'>" + CAMERA + "</scene>", expected));
        assertThat(changed(TEXT, database -> database.without(List.of("one")))).isEqualTo(TEXT.replace("  <scene name='one'>" + CAMERA + "</scene> <!-- good -->\n", ""));
        assertThat(changed(TEXT, database -> database.merge(SceneDatabase.EMPTY.plus(four, Scene.EMPTY.withName("one").withDescription("other")), Clash.REPLACE)))
                .isEqualTo(TEXT.replace("three'>" + CAMERA + "</scene>", expected).replace("'one'>", "'one'><description>other</description>"));
        assertThat(changed(TEXT, database -> SceneDatabase.EMPTY)).isEqualTo("""
                <!-- mine -->
                <database xmlns="urn:paprsek:scene:1">

                  <!-- first -->
                  <!-- last -->
                </database><!-- end -->
                """);
        assertThat(changed("<database xmlns='urn:paprsek:scene:1'/><!-- empty -->", database -> database.plus(four, four.withName("five")))).isEqualTo("""
                <database xmlns='urn:paprsek:scene:1'>
                  <scene name="four">
                    <camera position="0 1 5" direction="0 0 -1"/>
                  </scene>
                  <scene name="five">
                    <camera position="0 1 5" direction="0 0 -1"/>
                  </scene>
                </database><!-- empty -->""");
    }

    @Test
    void whatOthersWroteAroundMyChangeStays() throws Exception {
        Path file = Files.writeString(folder.resolve("db.xml"), TEXT);
        DatabaseFile mine = DatabaseFile.open(file);
        String theirs = TEXT.replace("<!-- inside -->", "<!-- inside, by others -->").replace("'three'", "'drei'");
        Files.writeString(file, theirs);
        mine.save(mine.database().rename("one", "eins"));
        String first = "  <!-- first -->\n  <scene name='one'>" + CAMERA + "</scene> <!-- good -->\n";
        assertThat(file).as("what is renamed comes last").hasContent(theirs.replace(first, "")
                .replace("drei'>" + CAMERA + "</scene>\n", "drei'>" + CAMERA + "</scene>\n" + first.replace("one", "eins").replaceFirst("^ *", "\t")));
        Files.writeString(file, TEXT);
        mine.update(database -> database.rename("one", "eins"));
        assertThat(file).hasContent(TEXT.replace("'one'", "'eins'"));
    }

    @Test
    void randomDatabasesLaidOutAtRandomBecomeWhatIsWanted() throws Exception {
        for (int seed = 0; seed < Integer.getInteger("paprsek.databases", 4); seed++) {
            Random random = new Random(seed);
            List<Scene> scenes = new ArrayList<>();
            for (int i = 0; i < 5; i++) {
                scenes.add(RandomScenes.of(seed + i).withName("scene " + i));
            }
            byte[] before = RandomLayout.of(SceneFiles.formatAll(scenes), seed).getBytes(StandardCharsets.UTF_8);
            Path file = Files.write(folder.resolve("db.xml"), before);
            DatabaseFile open = DatabaseFile.open(file);
            SceneDatabase first = open.database();
            RandomEdits edits = new RandomEdits(seed);
            for (int step = 0; step < 4; step++) {
                List<Scene> wanted = new ArrayList<>(open.database().scenes());
                if (random.nextInt(3) == 0) {
                    Collections.shuffle(wanted, random);
                }
                if (random.nextInt(3) == 0 && !wanted.isEmpty()) {
                    wanted.remove(random.nextInt(wanted.size()));
                }
                wanted.replaceAll(scene -> random.nextBoolean() ? scene : edits.any(scene).withName(scene.name()));
                wanted.add(random.nextInt(wanted.size() + 1), Scene.EMPTY.withName("new " + step));
                open = open.save(SceneDatabase.of(wanted));
                assertThat(DatabaseFile.open(file).database().scenes()).as("seed %d", seed).isEqualTo(wanted);
                OriginalText text = OriginalText.read(Files.write(folder.resolve("base.xml"), before), ReadMonitor.NONE);
                assertThat(text.patched(new FileText(before), wanted, SceneFiles.DEEPEST + 1)).as("not written anew").isPresent();
            }
            open.save(first);
            assertThat(Files.readAllBytes(file)).as("seed %d", seed).isEqualTo(before);
        }
    }
}
