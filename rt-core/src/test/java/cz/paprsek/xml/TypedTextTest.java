package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.asset.Assets;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneText.Stand;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Text that is written in while the scene changes. */
class TypedTextTest {
    private static final String TEXT = """
            <?xml version="1.0" encoding="ENCODING"?>
            <scene xmlns="urn:paprsek:scene:1" name="žluť"> <!-- ř -->
              <camera position="0 1 5" target="0 0 0"/>
              <sun-light direction="-1 -1 0"/>
              <sphere   radius='1' name="ball"/> <!-- kept -->
              <difference>
                <block min="-1 -1 -1" max="1 1 1"/>
                <sphere radius="1.2"/>
              </difference>
              <repeat count="3" position="1 0 0"><disc radius="0.5"/></repeat>
            </scene>
            """;

    private static SceneText read(byte[] bytes) throws IOException, SceneFileException {
        OriginalText text = OriginalText.read(new ByteArrayInputStream(bytes), "a.xml");
        return SceneText.of(Optional.of(text), text.contents().scenes().get(0));
    }

    private static byte[] bytes(SceneText text) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        text.kept().writeTo(out);
        return out.toByteArray();
    }

    @Test
    void whatIsTypedStandsInTheFileAndNothingElseChanges() throws IOException, SceneFileException {
        for (String encoding : List.of("UTF-8", "ISO-8859-2", "UTF-16")) {
            String mixed = TEXT.replace("ENCODING", encoding).replace("\n", "\r\n").replaceFirst("\r\n", "\n");
            Charset charset = Charset.forName(encoding);
            SceneText before = read(mixed.getBytes(charset));
            assertThat(before.characters()).doesNotContain("\r").startsWith("<?xml").contains("<!-- ř -->");
            String typed = before.characters().replace("radius='1'", "radius='1.5'\n   ");
            SceneText after = before.typed(typed, Assets.none());
            assertThat(after.scene().objects().get(0).shape()).isEqualTo(new Sphere(1.5));
            assertThat(new String(bytes(after), charset)).as(encoding).isEqualTo(mixed.replace("radius='1'", "radius='1.5'\r\n   "));
            assertThat(before.typed(before.characters(), Assets.none()).scene()).isEqualTo(before.scene());
            assertThat(after.scene().objects().get(1)).as("what has not changed is shared").isSameAs(before.scene().objects().get(1));
            assertThat(bytes(before.typed(before.characters(), Assets.none()))).as(encoding).isEqualTo(mixed.getBytes(charset));
        }
    }

    @Test
    void changesOfTheSceneAreChangesOfItsTextOnly() throws IOException, SceneFileException {
        SceneText before = read(TEXT.replace("ENCODING", "UTF-8").getBytes(StandardCharsets.UTF_8));
        Scene moved = before.scene().withObjects(Stream.concat(Stream.of(before.scene().objects().get(0).at(2, 0, 0)),
                before.scene().objects().stream().skip(1)).toList());
        String now = SceneText.of(Optional.of(before.kept()), moved).characters();
        assertThat(now).isEqualTo(before.characters().replace("name=\"ball\"/>", "name=\"ball\" position=\"2 0 0\"/>"));
        assertThat(SceneText.of(Optional.empty(), moved).characters()).isEqualTo(SceneFiles.format(moved));
    }

    @Test
    void commentsAreTakenIntoADatabaseToo(@TempDir Path folder) throws IOException, SceneFileException {
        Path file = folder.resolve("two.xml");
        SceneFiles.writeAll(List.of(Scene.EMPTY.withName("one"), Scene.EMPTY.withName("two")), file);
        DatabaseFile database = DatabaseFile.open(file);
        Scene one = database.database().scenes().get(0);
        SceneText text = SceneText.of(Optional.of(database.text()), one);
        SceneText typed = text.typed(text.characters().replace("</scene>", "  <!-- mine -->\n</scene>"), Assets.none());
        assertThat(typed.scene()).isEqualTo(one);
        database.update(all -> all.replace("one", one), typed.kept().alone(one));
        assertThat(Files.readString(file)).contains("<!-- mine -->");
        assertThat(DatabaseFile.open(file).database()).isEqualTo(database.database());
    }

    @Test
    void whatOthersWroteAndWhatWasTypedAreNotMixed(@TempDir Path folder) throws IOException, SceneFileException {
        String text = TEXT.replace("ENCODING", "UTF-8");
        Path file = Files.writeString(folder.resolve("a.xml"), text);
        SceneFile opened = SceneFiles.open(file);
        SceneText before = SceneText.of(Optional.of(opened.text()), opened.scene());
        SceneText typed = before.typed(before.characters().replace("kept", "mine"), Assets.none());
        SceneFile saved = opened.withText(typed.kept()).save(typed.scene());
        assertThat(file).hasContent(text.replace("kept", "mine"));
        String theirs = text.replace("kept", "theirs");
        Files.writeString(file, theirs);
        assertThatThrownBy(() -> saved.save(typed.scene())).isInstanceOf(DatabaseConflictException.class).hasMessageEndingWith("nothing is written");
        assertThat(file).hasContent(theirs);
        SceneFile seen = SceneFiles.open(file);
        assertThat(seen.isAs(saved)).isFalse();
        seen.withText(typed.kept()).save(typed.scene());
        assertThat(file).as("who has seen theirs may write over it").hasContent(text.replace("kept", "mine"));
        assertThat(SceneFiles.open(file).isAs(saved)).isTrue();
    }

    @Test
    void thingsStandWhereTheirElementsAre() throws IOException, SceneFileException {
        SceneText text = read(TEXT.replace("ENCODING", "UTF-8").getBytes(StandardCharsets.UTF_8));
        List<Stand> stands = text.stands();
        assertThat(stands).extracting(Stand::place).contains(ScenePath.camera(0), ScenePath.light(0), ScenePath.body(0), ScenePath.body(1, 1), ScenePath.body(2), ScenePath.body(4));
        assertThat(at(text, ScenePath.body(0))).isEqualTo("<sphere   radius='1' name=\"ball\"/>");
        assertThat(at(text, ScenePath.body(1, 1))).isEqualTo("<sphere radius=\"1.2\"/>");
        assertThat(at(text, ScenePath.body(1))).startsWith("<difference>").endsWith("</difference>");
        assertThat(at(text, ScenePath.body(3))).as("a copy").isEqualTo("<disc radius=\"0.5\"/>");
        assertThat(at(text, ScenePath.light(0))).startsWith("<sun-light");
    }

    /** A letter that takes more bytes than one is no reason to read everything before each thing again. */
    @Test
    @Timeout(20)
    void thingsAreFoundInLongTextsWithAnyLetters() throws IOException, SceneFileException {
        int count = 20_000;
        StringBuilder written = new StringBuilder("<scene xmlns=\"urn:paprsek:scene:1\"> <!-- ř 光 😀 -->\n<camera position=\"0 1 5\" target=\"0 0 0\"/>\n");
        for (int i = 0; i < count; i++) {
            written.append("<sphere name=\"").append(i).append(i % 2 == 0 ? " 😀" : " ř").append("\" radius=\"1\" position=\"0 ").append(i).append(" 0\"/><!-- a comment that makes it longer, as long as lines are that say more -->\n");
        }
        SceneText text = read(written.append("</scene>\n").toString().getBytes(StandardCharsets.UTF_8));
        List<Stand> stands = text.stands();
        assertThat(stands).hasSize(count + 1);
        for (int i : new int[]{0, 1, 2, count - 2, count - 1}) {
            Stand stand = stands.stream().filter(one -> one.place().equals(ScenePath.body(i))).findFirst().orElseThrow();
            assertThat(text.characters().substring(stand.from(), stand.to())).startsWith("<sphere name=\"" + i + " ").endsWith("/>");
        }
    }

    private static String at(SceneText text, ScenePath place) {
        Stand stand = text.stands().stream().filter(one -> one.place().equals(place)).findFirst().orElseThrow();
        return text.characters().substring(stand.from(), stand.to());
    }

    @Test
    void mistakesAreThoseOfFilesWithTheirLines() throws IOException, SceneFileException {
        SceneText text = read(TEXT.replace("ENCODING", "UTF-8").getBytes(StandardCharsets.UTF_8));
        assertThatThrownBy(() -> text.typed(text.characters().replace("radius='1'", "radius='-1'"), Assets.none())).isInstanceOfSatisfying(SceneFileException.class,
                wrong -> assertThat(wrong.problems().get(0)).extracting(Problem::line, Problem::column, Problem::message)
                        .containsExactly(5, 13, "sphere radius must be a finite number above 0, but is \"-1\""));
        assertThatThrownBy(() -> text.typed(text.characters().replace("</scene>", ""), Assets.none())).isInstanceOf(SceneFileException.class);
        assertThatThrownBy(() -> text.typed(SceneFiles.formatAll(List.of(text.scene().withName("a"))), Assets.none())).isInstanceOf(SceneFileException.class)
                .hasMessageContaining("one scene was expected");
    }
}
