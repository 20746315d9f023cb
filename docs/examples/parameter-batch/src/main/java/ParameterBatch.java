import cz.paprsek.image.ImageFiles;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe.Parameter;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;

/** A picture for each of some values of one parameter of a scene: {@code ParameterBatch gear.xml teeth 8 12 24} writes gear-teeth-8.png and so on. */
public final class ParameterBatch {
    private ParameterBatch() {}

    public static void main(String[] args) throws IOException {
        if (args.length < 3) {
            System.err.println("usage: ParameterBatch SCENE.xml PARAMETER VALUE...");
            System.exit(2);
        }
        try {
            render(Path.of(args[0]), args[1], Path.of(""), Arrays.asList(args).subList(2, args.length));
        } catch (SceneFileException wrong) {
            wrong.problems().forEach(System.err::println);
            System.exit(3);
        }
    }

    static void render(Path file, String name, Path folder, Iterable<String> values) throws IOException, SceneFileException {
        Scene scene = SceneFiles.read(file);
        String known = String.join(", ", scene.recipe().parameters().stream().map(Parameter::name).toList());
        System.out.println(file + " has the parameters " + known);
        String stem = file.getFileName().toString().replaceFirst("\\.xml$", "");
        for (String value : values) {
            Path picture = folder.resolve(stem + "-" + name + "-" + value + ".png");
            ImageFiles.write(Renderer.render(SceneFiles.with(scene, Map.of(name, value))), picture);
            System.out.println(picture);
        }
    }
}
