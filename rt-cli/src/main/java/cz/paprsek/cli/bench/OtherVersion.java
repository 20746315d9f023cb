package cz.paprsek.cli.bench;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Another version of this program, loaded from its jar beside our own. They share nothing but the virtual machine, which compiles both by
 * what each of them does. Makes its scenes itself, which must still be called as ours are.
 */
final class OtherVersion implements Rival {
    private static final String[] MAKERS = {"cz.paprsek.cli.bench.BenchScenes", "cz.paprsek.cli.BenchScenes"};

    private final Path jar;
    private final ClassLoader loader;
    private final Stop stop;
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final Map<Thread, Long> nanos = new ConcurrentHashMap<>();
    private String name = "";
    private Object prepared = "";
    private Object options = "";

    /** Looks into the jar. */
    OtherVersion(Path jar, Stop stop) {
        if (!Files.isRegularFile(jar)) {
            throw new WrongUsage("--against-jar: there is no file " + jar);
        }
        this.jar = jar;
        this.stop = stop;
        try {
            this.loader = new URLClassLoader(new URL[] {jar.toUri().toURL()}, ClassLoader.getPlatformClassLoader());
            maker();
        } catch (IOException | ReflectiveOperationException e) {
            throw new WrongUsage("--against-jar: " + jar + " is no jar of this program");
        }
    }

    @Override
    public String label() {
        return "old";
    }

    @Override
    public String version() {
        return jar.toString();
    }

    @Override
    public boolean warmsUp() {
        return true;
    }

    @Override
    public double seconds(String scene, Scene ours, int workers) throws IOException {
        try {
            if (!name.equals(scene)) {
                prepare(scene, ours, workers);
                name = scene;
            }
            nanos.clear();
            type("render.Renderer").getMethod("render", type("render.RenderScene"), type("render.RenderOptions"), type("render.RenderMonitor"))
                    .invoke(null, prepared, options, monitor());
            return nanos.values().stream().mapToLong(Long::longValue).sum() / 1e9;
        } catch (ReflectiveOperationException e) {
            throw new IOException("the other version cannot render " + scene + ": " + (e.getCause() == null ? e : e.getCause()), e);
        }
    }

    private void prepare(String scene, Scene ours, int workers) throws ReflectiveOperationException {
        Class<?> type = type("scene.Scene");
        Object standard = maker().invoke(null, scene);
        Object settings = type.getMethod("settings").invoke(standard);
        Object sized = settings.getClass().getMethod("withSize", int.class, int.class).invoke(settings, ours.settings().width(), ours.settings().height());
        Object made = type.getMethod("withSettings", settings.getClass()).invoke(standard, sized);
        prepared = type("render.RenderScene").getMethod("of", type).invoke(null, made);
        Object wishes = type("render.RenderOptions").getMethod("of", type).invoke(null, made);
        options = wishes.getClass().getMethod("withThreads", int.class).invoke(wishes, workers);
    }

    private Method maker() throws ReflectiveOperationException {
        for (String candidate : MAKERS) {
            try {
                Method make = Class.forName(candidate, true, loader).getDeclaredMethod("make", String.class);
                make.setAccessible(true);
                return make;
            } catch (ClassNotFoundException e) {
                // It may lie where older versions have it.
            }
        }
        throw new ClassNotFoundException(MAKERS[0]);
    }

    private Class<?> type(String name) throws ClassNotFoundException {
        return Class.forName("cz.paprsek." + name, true, loader);
    }

    /** As {@link CpuTime}, for the other version's renders. */
    private Object monitor() throws ClassNotFoundException {
        return Proxy.newProxyInstance(loader, new Class<?>[] {type("render.RenderMonitor")}, (proxy, method, arguments) -> {
            if (method.getName().equals("finished")) {
                nanos.put(Thread.currentThread(), threads.getCurrentThreadCpuTime());
            }
            return method.getReturnType() == boolean.class ? stop.requested() : null;
        });
    }
}
