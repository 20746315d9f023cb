package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.lang.annotation.Annotation;
import java.lang.reflect.AnnotatedElement;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What GraalVM's native-image is told in the library's jar: what is asked by reflection, and what is read from the jar. */
class NativeImageTest {
    private static final Path TOLD = Path.of("src/main/resources/META-INF/native-image/cz.paprsek/rt-core");
    private static final Path CLASSES = Path.of("target/classes");
    private static final String OURS = "cz.paprsek.";
    private static final String JAXB = "jakarta.xml.bind.";

    /** Records say what their attributes are; what is read, written and shown goes by that. Beans are filled by JAXB. After a new shape, what this test has written is put in the place of the old list. */
    @Test
    void allThatIsAskedByReflectionIsListed() throws Exception {
        SortedSet<String> entries = new TreeSet<>();
        SortedSet<String> seen = new TreeSet<>();
        walk(Scene.class, seen, entries);
        for (Class<?> bean : beans()) {
            entries.add(entry(bean, "allDeclaredConstructors", "allDeclaredMethods", "allDeclaredFields", "allDeclaredClasses"));
        }
        String list = entries.stream().collect(Collectors.joining(",\n  ", "[\n  ", "\n]\n"));
        Path written = Files.writeString(Path.of("target/reflect-config.json"), list);
        assertThat(entries).hasSizeGreaterThan(80);
        assertThat(Files.readString(TOLD.resolve("reflect-config.json"))).as("rt-core/%s is as it should be: copy it to rt-core/%s", written, TOLD).isEqualTo(list);
    }

    /** Whoever else begins to ask by reflection has to be thought of here. */
    @Test
    void reflectionIsWhereItIsKnown() {
        List<String> askers = new ClassFileImporter().withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS).importPath(CLASSES).stream()
                .filter(type -> type.getMethodCallsFromSelf().stream().anyMatch(call -> call.getTargetOwner().getName().equals("java.lang.Class")
                        && call.getName().matches("forName|getRecordComponents|getConstructor|getDeclared\\w+|getMethods?|getFields?|getPermittedSubclasses")))
                .map(JavaClass::getSimpleName).distinct().sorted().toList();
        assertThat(askers).as("vectors are not for native images, which have their own kernel; libraries that may be missing are said to be missing").containsExactly(
                "CameraForm", "Described", "ElementTable", "Elements", "Kernel", "Libraries", "LightForm", "MaterialReader", "PatternForm", "RecordForm", "RecordValues", "Schema", "ShapeBeans");
    }

    /** All that lies beside the classes is found in the image, and no pattern is for nothing. */
    @Test
    void allThatIsReadFromTheJarIsListed() throws IOException {
        List<Pattern> patterns = Pattern.compile("\"pattern\": \"(.*)\"").matcher(Files.readString(TOLD.resolve("resource-config.json"))).results()
                .map(one -> Pattern.compile(one.group(1).replace("\\\\", "\\"))).toList();
        List<String> files;
        try (Stream<Path> all = Files.walk(CLASSES.resolve("cz"))) {
            files = all.filter(Files::isRegularFile).map(file -> CLASSES.relativize(file).toString().replace('\\', '/'))
                    .filter(file -> !file.endsWith(".class") && !file.endsWith("LICENCE.txt")).toList();
        }
        assertThat(files).hasSizeGreaterThan(30).allSatisfy(file -> assertThat(patterns).anyMatch(pattern -> pattern.matcher(file).matches()));
        assertThat(patterns).allSatisfy(pattern -> assertThat(files).anyMatch(file -> pattern.matcher(file).matches()));
    }

    /** Records and the sealed types between them, from the scene on down. */
    private static void walk(Type type, SortedSet<String> seen, SortedSet<String> entries) {
        if (type instanceof ParameterizedType made) {
            Arrays.stream(made.getActualTypeArguments()).forEach(argument -> walk(argument, seen, entries));
        } else if (type instanceof Class<?> one && one.isArray()) {
            walk(one.getComponentType(), seen, entries);
        } else if (type instanceof Class<?> one && one.getName().startsWith(OURS) && seen.add(one.getName())) {
            if (one.isRecord()) {
                entries.add(entry(one, "allPublicConstructors", "allPublicMethods", "allRecordComponents"));
                for (RecordComponent component : one.getRecordComponents()) {
                    walk(component.getGenericType(), seen, entries);
                }
            }
            if (one.isSealed()) {
                entries.add(entry(one, "allPublicMethods", "allPermittedSubclasses"));
                Arrays.stream(one.getPermittedSubclasses()).forEach(kind -> walk(kind, seen, entries));
            }
        }
    }

    private static List<Class<?>> beans() throws IOException {
        try (Stream<Path> files = Files.list(CLASSES.resolve("cz/paprsek/xml/bind"))) {
            List<Class<?>> all = files.map(file -> String.valueOf(file.getFileName())).filter(name -> name.endsWith(".class") && !name.startsWith("package-info"))
                    .<Class<?>>map(name -> loaded("cz.paprsek.xml.bind." + name.replace(".class", ""))).filter(type -> !type.isSynthetic() && !type.isAnonymousClass()).toList();
            return all.stream().filter(type -> all.stream().anyMatch(other -> type.isAssignableFrom(other) && isBean(other)) || all.stream().anyMatch(inner -> inner.getDeclaringClass() == type && isBean(inner))).toList();
        }
    }

    private static boolean isBean(Class<?> type) {
        return Stream.<Class<?>>iterate(type, Objects::nonNull, Class::getSuperclass).anyMatch(one -> one.getName().startsWith(JAXB))
                || Stream.of(Stream.of(type), Arrays.stream(type.getDeclaredFields()), Arrays.stream(type.getDeclaredMethods())).flatMap(all -> all).anyMatch(NativeImageTest::isBound);
    }

    private static boolean isBound(AnnotatedElement element) {
        return Arrays.stream(element.getAnnotations()).map(Annotation::annotationType).anyMatch(kind -> kind.getName().startsWith(JAXB));
    }

    private static Class<?> loaded(String name) {
        try {
            return Class.forName(name);
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }

    private static String entry(Class<?> type, String... all) {
        return "{\"name\": \"" + type.getName() + "\"" + Arrays.stream(all).map(one -> ", \"" + one + "\": true").collect(Collectors.joining()) + "}";
    }
}
