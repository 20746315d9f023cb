package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe.Parameter;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.text.Numbers;
import java.nio.ByteBuffer;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Scenes that were written by hand, copy for copy, and are made by repetition and definitions now. */
@Timeout(60)
class RepeatedScenesTest {
    private static final SceneDatabase DATABASE = SceneFiles.examples();

    /** The digests are those of the pictures, 32 × 18, when every copy was written down. */
    @ParameterizedTest
    @CsvSource({
        "Brick, 36d0dbb3c1bb361413731c7691c35c3b0416deaea9634aaaa493af42a2691f5e",
        "Buckyball, bb5ce7f868bdf853a3955fa3e8c447bd6b46cfe72c907eb9d5d31dd29a0f6586",
        "Castle, 6d4a53f3d51dd129378386c5c31ebecf762160797b125bb83b7ec79a24910c64",
        "Chess set, ec2c9653ff6c2088a984fd376b32873d1aa5090cfa07bcd56242e8f3268614bc",
        "Double helix, 92d9ad6e093268c50132452efc2af23c2a25b6c319d4945b2609520bacc53a68",
        "Drawing board, 5e607e7eff834e8c945204a6fb586021f54a8b3d498069c701b7f03c08caceda",
        "Evening sun, b8b82543a0ed68f3e4fddef7302155164391801f5f585f417aa960a82a47a8cf",
        "Gears, 8f80d48b247fdf6d12e5cd5485bb6274e898adf8320014c03b759d393f77e7c3",
        "Iced water, df1e67f521b17d6beefbaaae83ebbb4a3dc0b54706869d4a9b578ac1381a461d",
        "Menger sponge, 7735503b27433745e16fbf616e29e56e23c1ffb148e77898812bc9df9b4f5982",
        "Newton's cradle, 97aeb1b62eb3275c3a65c32a71750ad45956c0917bf757faf82cfcc04dd0c3fe",
        "Panorama, 48d7fd858548b03ff870299a67040dfec2e39263afbac811870c4a118393308f",
        "Pearls, c583928392a87dac29c299c1d952a59d1f7ed1daf675391a341bb2bc7ade8de8",
        "Prism, 98fcde592ccb903db54f57431eba3881cd890f07c6ee9974337396e06ca8c410",
        "Puzzle cube, a97ece540ba488c4372fd4f2e40c5fd20f04ac23893c3d7f0f136d51e1aeeb87",
        "Rainbow discs, 9a38309436b65a75b2b4c660c06676587da0b1c6a93e1cbb6227faf5965eded4",
        "Sphereflake, 148361cb9e0454afdf62446945c910e907fa612a53109171d27f66d94a46e796",
        "Stone circle, 9cd9103bc60abc108629f1f237c5994865ff4dbeb126cab8b12c3599d79f039f",
        "Temple, 93620349dcfe26b9304a534436b12f6a4b0a8b9a7c4dd4d889f551ea9ab05c4e",
        "Test scene, 3740f4834ec628988958e88dfb4617c66ecbc4fb8fa1166a5705f48d44b5291b",
        "Threads, df1dab6e2f7beeef00af6c8baf3ae3324e516c1508bd3786233141193e40aad3",
        "Under the dome, 25d2e05de0890bdf24ee8d8710ce0e0438f8af28be20a278fa859dce6cd3815c"})
    void thePictureIsTheSameToTheLastBit(String name, String digest) throws Exception {
        Scene scene = DATABASE.get(name);
        assertThat(scene.recipe().isNone()).isFalse();
        Image image = Renderer.render(scene.withSettings(scene.settings().withSize(32, 18).withSamples(1)));
        ByteBuffer bits = ByteBuffer.allocate(12 * 32 * 18);
        for (int y = 0; y < 18; y++) {
            for (int x = 0; x < 32; x++) {
                bits.putFloat(image.red(x, y)).putFloat(image.green(x, y)).putFloat(image.blue(x, y));
            }
        }
        assertThat(HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bits.array()))).isEqualTo(digest);
    }

    @ParameterizedTest
    @ValueSource(strings = {"gear", "brick", "chess-set", "sign", "stair", "forest"})
    void oneSliderMakesAnotherSceneOfAtMostFortyLines(String name) throws Exception {
        Path file = Path.of("../scenes", name + ".xml");
        assertThat(Files.readAllLines(file)).hasSizeLessThanOrEqualTo(40);
        Scene scene = SceneFiles.read(file);
        Parameter parameter = scene.recipe().parameters().stream().filter(one -> one.least().isPresent() && one.most().isPresent()).findFirst().orElseThrow();
        Scene least = SceneFiles.with(scene, Map.of(parameter.name(), Numbers.text(parameter.least().getAsDouble())));
        assertThat(least.objects()).isNotEqualTo(scene.objects());
        assertThat(SceneFiles.parse(SceneFiles.format(least))).isEqualTo(least);
    }

    @Test
    void theDatabaseHasTheScenesOfTheseFiles() throws Exception {
        for (String name : new String[] {"gear", "brick", "chess-set", "stair", "forest"}) {
            Scene scene = SceneFiles.read(Path.of("../scenes", name + ".xml"));
            assertThat(DATABASE.get(scene.name())).isEqualTo(scene);
        }
    }

    @Test
    void everySliderMakesASceneAtBothItsEnds() throws Exception {
        List<String> refused = new ArrayList<>();
        List<Scene> scenes = new ArrayList<>(DATABASE.scenes());
        try (DirectoryStream<Path> files = Files.newDirectoryStream(Path.of("../scenes"), "*.xml")) {
            for (Path file : files) {
                scenes.addAll(SceneFiles.readAll(file));
            }
        }
        for (Scene scene : scenes) {
            for (Parameter parameter : scene.recipe().parameters()) {
                for (OptionalDouble end : List.of(parameter.least(), parameter.most())) {
                    try {
                        SceneFiles.with(scene, end.isPresent() ? Map.of(parameter.name(), Numbers.text(end.getAsDouble())) : Map.of());
                    } catch (SceneFileException why) {
                        refused.add(scene.name() + " with " + parameter.name() + " " + end + ": " + why.problems().get(0).message());
                    }
                }
            }
        }
        assertThat(refused).isEmpty();
    }
}
