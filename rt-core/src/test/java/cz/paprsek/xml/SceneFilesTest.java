package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.material.MaterialName;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlElements;
import java.io.IOException;
import java.lang.reflect.Field;
import java.lang.reflect.ParameterizedType;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class SceneFilesTest {
    @TempDir
    Path folder;

    static Stream<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("../scenes"))) {
            return files.filter(file -> file.toString().endsWith(".xml")).sorted().toList().stream();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everyShippedFileIsWrittenAsItWasRead(Path file) throws Exception {
        List<Scene> scenes = SceneFiles.readAll(file);
        String text = SceneFiles.isDatabase(file) ? SceneFiles.formatAll(scenes) : SceneFiles.format(scenes.get(0));
        assertThat(text).isEqualTo(Files.readString(file));
        assertThat(SceneFiles.readAll(Files.writeString(folder.resolve("again.xml"), text))).isEqualTo(scenes);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void whatIsWrittenReadsBackEqual(long seed) throws Exception {
        Scene scene = RandomScenes.of(seed);
        String text = SceneFiles.format(scene);
        assertThat(SceneFiles.parse(text)).isEqualTo(scene);
        assertThat(SceneFiles.format(SceneFiles.parse(text))).isEqualTo(text);
    }

    @Test
    void aDatabaseKeepsItsScenesInOrder(@TempDir Path folder) throws Exception {
        List<Scene> scenes = List.of(RandomScenes.of(1), RandomScenes.of(2).withName("two"), RandomScenes.of(3).withName("three"));
        Path file = folder.resolve("database.xml");
        SceneFiles.writeAll(scenes, file);
        assertThat(SceneFiles.readAll(file)).isEqualTo(scenes);
        assertThat(folder.toFile().list()).as("no temporary file is left").containsExactly("database.xml");
    }

    @Test
    void writingKeepsTheOldFilesPermissions(@TempDir Path folder) throws Exception {
        Path file = Files.writeString(folder.resolve("a.xml"), "old");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-rw-r--"));
        SceneFiles.write(RandomScenes.of(1), file);
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file))).isEqualTo("rw-rw-r--");
        assertThat(SceneFiles.read(file)).isEqualTo(RandomScenes.of(1));
    }

    @Test
    void elementsMayComeInAnyOrder() throws Exception {
        Scene scene = SceneFiles.parse("""
                <scene xmlns="urn:paprsek:scene:1">
                  <sphere radius="1" material="later"/>
                  <material name="later" color="1 2 3"/>
                  <camera position="0 0 5" target="0 0 0"/>
                  <render width="10"/>
                </scene>""");
        assertThat(scene.objects().get(0).material()).isEqualTo(new MaterialName("later"));
        assertThat(scene.settings()).isEqualTo(RenderSettings.DEFAULT.withSize(10, 600));
    }

    /** The attributes that beans bind are those the schema allows, for every element, nested ones included. */
    @Test
    void beansAndSchemaAgree() {
        Grammar grammar = Grammar.ofScenes();
        compare(grammar, "Scene", SceneBean.class, new HashSet<>());
    }

    private static void compare(Grammar grammar, String type, Class<?> bean, Set<String> done) {
        if (!done.add(type + bean.getName())) {
            return;
        }
        Set<String> attributes = new TreeSet<>();
        Map<String, Class<?>> children = new TreeMap<>();
        for (Class<?> c = bean; c != Object.class; c = c.getSuperclass()) {
            for (Field field : c.getDeclaredFields()) {
                XmlAttribute attribute = field.getAnnotation(XmlAttribute.class);
                if (attribute != null) {
                    attributes.add(attribute.name().equals("##default") ? field.getName() : attribute.name());
                }
                XmlElement element = field.getAnnotation(XmlElement.class);
                if (element != null) {
                    Class<?> held = field.getGenericType() instanceof ParameterizedType list
                            ? (Class<?>) list.getActualTypeArguments()[0] : field.getType();
                    children.put(element.name().equals("##default") ? field.getName() : element.name(), held);
                }
                XmlElements several = field.getAnnotation(XmlElements.class);
                if (several != null) {
                    Arrays.stream(several.value()).forEach(e -> children.put(e.name(), e.type()));
                }
            }
        }
        Set<String> allowed = new TreeSet<>(grammar.attributes(type).keySet());
        // One bean serves named and unnamed materials.
        if (type.equals("Material")) {
            allowed.add("name");
        }
        assertThat(attributes).as("attributes of %s", type).isEqualTo(allowed);
        assertThat(children.keySet()).as("elements in %s", type).isEqualTo(new TreeSet<>(grammar.children(type).keySet()));
        grammar.children(type).forEach((name, childType) -> {
            Class<?> child = children.getOrDefault(name, String.class);
            if (child != String.class) {
                compare(grammar, childType, child, done);
            }
        });
    }
}
