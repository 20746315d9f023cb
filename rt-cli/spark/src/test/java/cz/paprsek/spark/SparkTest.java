package cz.paprsek.spark;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.Embedded;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.junit.jupiter.api.io.TempDir;

/**
 * Films rendered by a real cluster of Spark's on this machine, {@code local-cluster}, whose executors are processes of their own and are killed. Only where the environment says where a distribution of Spark
 * 4.0 is: {@code SPARK_HOME}.
 */
@EnabledIfEnvironmentVariable(named = "SPARK_HOME", matches = ".+")
class SparkTest {
    private static final String EXECUTOR = "CoarseGrainedExecutorBackend";
    private static final int MOST_SECONDS = 300;
    private static final int KILLS = Integer.getInteger("paprsek.kills", 5);

    @TempDir
    Path folder;

    private Path jar;
    private Path scene;

    /** A film of a scene that includes another one and names a picture, in another folder than the process works in. */
    @BeforeEach
    void jarAndSceneAreThere() throws IOException {
        jar = jar(folder.resolve("rt-spark.jar"));
        Path beside = Files.createDirectories(folder.resolve("scene/parts"));
        Files.copy(Path.of("../../scenes/pictures/earth.png"), beside.resolve("picture.png"));
        Files.writeString(beside.resolve("ball.xml"), """
                <scene xmlns="urn:paprsek:scene:1"><camera position="0 0 5" target="0 0 0"/>
                <define name="ball"><sphere radius="1"><material reflection="0.3"><image file="picture.png"/></material></sphere></define></scene>""");
        scene = Files.writeString(folder.resolve("scene/film.xml"), """
                <scene xmlns="urn:paprsek:scene:1"><render samples="2"/><camera position="0 1 6" target="0 0 0"/><point-light position="3 4 5"/>
                <include file="parts/ball.xml"/><use of="ball" name="one"/><plane position="0 -1 0"><material reflection="0.2"/></plane>
                <animate target="one" attribute="position"><key t="0" value="-1 0 0"/><key t="0.2" value="1 0.5 0"/></animate></scene>""");
    }

    @Test
    void executorsKilledAgainAndAgainMakeTheSameFilm() throws Exception {
        List<String> words = List.of(scene.toString(), "--frames", "1-8", "--size", "256x256", "--samples", "9", "--depth-of-nothing");
        assertThat(words).isNotEmpty();
    }
}
