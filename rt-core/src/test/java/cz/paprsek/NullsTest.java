package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Examples;
import cz.paprsek.shape.Sphere;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.lang.reflect.Array;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Proxy;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Whoever passes null is told at once, not when the null is met much later, somewhere else. */
class NullsTest {
    private static final List<Class<?>> PUBLIC = new ClassFileImporter().withImportOption(new ImportOption.DoNotIncludeTests()).importPackages("cz.paprsek").stream()
            .filter(type -> type.getModifiers().contains(JavaModifier.PUBLIC)).map(JavaClass::reflect).<Class<?>>map(type -> type)
            .filter(NullsTest::isVisible).sorted(Comparator.comparing(Class::getName)).toList();
    /** Only this library itself goes there. */
    private static final Pattern INNER = Pattern.compile("cz\\.paprsek\\.(tree|list|attribute|image\\.(exr|png)|format\\.\\w+|xml\\.(bind|format|mistake|quick|text|typing|write)|render\\.(buffer|denoise|eye|glow|hull|integrate|lanes|light|show|surface|texture|work)|scene\\.motion|shape\\.(copied|placed))|"
            + "cz\\.paprsek\\.(math\\.Require|io\\.BinaryInput)");
    /** Equal to nothing; for the renderer alone; and what a caller's own function is asked about. */
    private static final Set<String> NOT_CHECKED = Set.of("equals", "place", "cell");
    private final List<Object> known = new ArrayList<>();

    @Test
    void nullsAreRefusedWhereTheyComeIn() {
        known.addAll(List.of("a", 1, 1.0, true, Path.of("target", "nulls", "a.png"), Vec3.ZERO, List.of(), Map.of(), new Image(2, 2), Material.DEFAULT,
                (BooleanSupplier) () -> false, new ByteArrayInputStream(new byte[0]), new ByteArrayOutputStream(), NullsTest.class.getClassLoader(), RenderMonitor.NONE, Scene.EMPTY.plus(SceneObject.of(new Sphere(1))), Optional.empty()));
        known.addAll(Examples.ALL.values());
        for (int round = 0; round < 3; round++) {
            PUBLIC.forEach(this::make);
        }
        Set<String> accepted = new TreeSet<>();
        int tried = 0;
        for (Class<?> type : PUBLIC) {
            if ((type.isInterface() && !type.isSealed()) || INNER.matcher(type.getName()).lookingAt()) {
                continue;
            }
            for (Executable way : (Iterable<Executable>) Stream.concat(Arrays.stream(type.getConstructors()), Arrays.stream(type.getDeclaredMethods()))::iterator) {
                tried += refusals(type, way, accepted);
            }
        }
        assertThat(accepted).isEmpty();
        assertThat(tried).isGreaterThan(300);
    }

    private int refusals(Class<?> type, Executable way, Set<String> accepted) {
        if (!Modifier.isPublic(way.getModifiers()) || Modifier.isAbstract(way.getModifiers()) || way.isSynthetic() || NOT_CHECKED.contains(way.getName())) {
            return 0;
        }
        Optional<Object> owner = way instanceof Method && !Modifier.isStatic(way.getModifiers()) ? example(type) : Optional.of("");
        Optional<Object[]> arguments = arguments(way);
        int tried = 0;
        for (int i = 0; i < way.getParameterCount(); i++) {
            if (owner.isPresent() && arguments.isPresent() && !way.getParameterTypes()[i].isPrimitive()) {
                Object[] with = arguments.get().clone();
                with[i] = null;
                tried++;
                String name = type.getSimpleName() + "." + way.getName() + " " + i + " " + way.getParameters()[i].getType().getSimpleName();
                try {
                    call(way, owner.get(), with);
                    accepted.add(name + ": accepted");
                } catch (InvocationTargetException thrown) {
                    Throwable fault = thrown.getCause();
                    if (!(fault instanceof NullPointerException || fault instanceof IllegalArgumentException) || String.valueOf(fault.getMessage()).equals("null")) {
                        accepted.add(name + ": " + fault);
                    }
                }
            }
        }
        return tried;
    }

    private void make(Class<?> type) {
        if (type.isEnum()) {
            known.add(type.getEnumConstants()[0]);
            return;
        }
        Stream<Executable> factories = Arrays.stream(type.getDeclaredMethods()).filter(method -> Modifier.isStatic(method.getModifiers())
                && Modifier.isPublic(method.getModifiers()) && type.isAssignableFrom(method.getReturnType())).map(method -> method);
        Stream<Executable> constructors = Modifier.isAbstract(type.getModifiers()) ? Stream.of() : Arrays.stream(type.getConstructors());
        for (Executable way : (Iterable<Executable>) Stream.concat(constructors, factories)::iterator) {
            if (known.stream().anyMatch(type::isInstance)) {
                return;
            }
            arguments(way).ifPresent(arguments -> {
                try {
                    known.add(call(way, "", arguments));
                } catch (InvocationTargetException unsuitable) {
                    // Others may do.
                }
            });
        }
    }

    private static Object call(Executable way, Object owner, Object[] arguments) throws InvocationTargetException {
        try {
            return way instanceof Constructor<?> constructor ? constructor.newInstance(arguments) : ((Method) way).invoke(owner, arguments);
        } catch (InstantiationException | IllegalAccessException e) {
            throw new IllegalStateException(way.toString(), e);
        }
    }

    private Optional<Object[]> arguments(Executable way) {
        Object[] arguments = new Object[way.getParameterCount()];
        for (int i = 0; i < arguments.length; i++) {
            Optional<Object> example = example(way.getParameterTypes()[i]);
            if (example.isEmpty()) {
                return Optional.empty();
            }
            arguments[i] = example.get();
        }
        return Optional.of(arguments);
    }

    private Optional<Object> example(Class<?> type) {
        if (type.isPrimitive()) {
            Object one = Array.get(Array.newInstance(type, 1), 0);
            return Optional.of(type == int.class ? 1 : type == double.class ? 1.0 : type == long.class ? 1L : type == float.class ? 1f : one);
        }
        if (type.isArray()) {
            return Optional.of(Array.newInstance(type.getComponentType(), 3));
        }
        Optional<Object> found = known.stream().filter(type::isInstance).findFirst();
        return found.isPresent() || !type.isInterface() || type.isSealed() ? found
                : Optional.of(Proxy.newProxyInstance(type.getClassLoader(), new Class<?>[] {type}, (self, method, values) -> {
                    throw new UnsupportedOperationException(method.getName());
                }));
    }

    private static boolean isVisible(Class<?> type) {
        return type.getEnclosingClass() == null || (Modifier.isPublic(type.getEnclosingClass().getModifiers()) && isVisible(type.getEnclosingClass()));
    }
}
