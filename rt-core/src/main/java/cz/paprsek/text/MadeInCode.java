package cz.paprsek.text;

import java.util.Locale;
import java.util.Objects;

/** What is made in code: only the code itself knows what it is. */
public final class MadeInCode {
    private MadeInCode() {}

    /** The word for something by its class; of one without a name, such as an anonymous one, by what it extends or implements. */
    public static String kind(Object made) {
        Class<?> type = made.getClass();
        while (type.isHidden() || type.getSimpleName().isEmpty()) {
            type = type.getSuperclass() == Object.class ? type.getInterfaces()[0] : type.getSuperclass();
        }
        return type.getSimpleName().replaceAll("(?<=[a-z])(?=[A-Z])", "-").toLowerCase(Locale.ROOT);
    }

    /**
     * Says that something made in code cannot be written.
     *
     * @param holder where to: {@code a scene file}
     * @param kind what it is called
     * @param what a shape, a pattern or a light
     */
    public static IllegalArgumentException refusedBy(String holder, String kind, String what) {
        Objects.requireNonNull(holder, "holder");
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(what, "what");
        return new IllegalArgumentException(holder + " cannot hold the " + what + " \"" + kind + "\", which is made in code");
    }
}
