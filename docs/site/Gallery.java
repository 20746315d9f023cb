import cz.paprsek.asset.Assets;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * Renders thirty scenes and writes the page that shows them, with what docs/scenes.md says of each. After {@code mvn -DskipTests package}, in the project's folder:
 * <pre>java -cp rt-cli/target/rt-cli.jar docs/site/Gallery.java</pre>
 */
class Gallery {
    private static final int WIDTH = 288;
    private static final List<String> NAMES = List.of("showcase", "tumbler", "four-lines", "glass", "lens", "gem", "absorption", "fresnel", "rough", "neon", "mirrors", "dice", "csg", "gyroid", "gear",
            "brick", "chess-set", "chess", "stair", "sign", "solids", "shell", "patterns", "bumps", "polished", "pictures", "room", "soft-shadows", "stage", "evening-sun");

    public static void main(String[] words) throws Exception {
        Map<String, String> shows = new LinkedHashMap<>();
        Pattern.compile("(?m)^\\| `([\\w-]+)\\.xml` \\| (.*) \\|$").matcher(Files.readString(Path.of("docs/scenes.md"))).results().forEach(row -> shows.put(row.group(1), row.group(2)));
        Path folder = Files.createDirectories(Path.of("docs/gallery"));
        StringBuilder page = new StringBuilder("""
                # Gallery

                Thirty of the [scenes to open](scenes.md), small. The times are those of one processor for these very pictures, in seconds; a picture of twice the width takes four times as long, and two processors
                half of it. `java -cp rt-cli/target/rt-cli.jar docs/site/Gallery.java` renders all and writes this page.

                | | |
                |---|---|
                """);
        var machine = (com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        for (String name : NAMES) {
            Path file = Path.of("scenes", name + ".xml");
            Scene read = SceneFiles.read(file);
            int height = (int) Math.round(WIDTH * (double) read.settings().height() / read.settings().width());
            Scene scene = read.withSettings(height <= WIDTH ? read.settings().withSize(WIDTH, height) : read.settings().withSize(WIDTH * WIDTH / height, WIDTH));
            long begin = machine.getProcessCpuTime();
            var result = Renderer.render(RenderScene.of(scene, Assets.beside(file), RenderMonitor.NONE), RenderOptions.of(scene), RenderMonitor.NONE);
            double seconds = (machine.getProcessCpuTime() - begin) / 1e9;
            ImageFiles.write(result.image(), folder.resolve(name + ".jpg"),
                    ImageOptions.DEFAULT.withExposure(scene.settings().exposure()).withTone(scene.settings().tone()));
            page.append(String.format(Locale.ROOT, "| ![%s](gallery/%s.jpg) | [`%s.xml`](../scenes/%s.xml)<br/>%s<br/>%.1f s |%n", shows.get(name), name, name, name, shows.get(name), seconds));
            System.out.printf(Locale.ROOT, "%-14s %6.1f s%n", name, seconds);
        }
        Files.writeString(Path.of("docs/gallery.md"), page);
    }
}
