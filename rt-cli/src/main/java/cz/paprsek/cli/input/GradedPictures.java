package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.io.Failures;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** The pictures that a user's words stand for. */
public final class GradedPictures {
    private GradedPictures() {}

    /**
     * Files as they are; of a folder those in it whose ending is that of a picture, sorted.
     *
     * @throws WrongUsage if a folder has none, or cannot be read
     */
    public static List<Path> files(List<String> words) {
        List<Path> found = new ArrayList<>();
        for (Path path : SceneArguments.files(words)) {
            found.addAll(Files.isDirectory(path) ? within(path) : List.of(path));
        }
        return found;
    }

    private static List<Path> within(Path folder) {
        try (Stream<Path> all = Files.list(folder)) {
            List<Path> pictures = all.filter(file -> Files.isRegularFile(file) && ImageFormat.ofFile(file.toString()).isPresent()).sorted().toList();
            if (pictures.isEmpty()) {
                throw new WrongUsage("no picture is in " + folder);
            }
            return pictures;
        } catch (IOException e) {
            throw new WrongUsage(Failures.sentence(folder.toString(), e));
        }
    }
}
