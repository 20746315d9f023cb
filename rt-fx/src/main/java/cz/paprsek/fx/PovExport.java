package cz.paprsek.fx;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.Belongings;
import cz.paprsek.format.MeshFiles;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.io.Failures;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Writes a scene for POV-Ray, with the files that it needs beside it, and tells what is not shown there as it is here. */
final class PovExport {
    /** Of more differences, only how many there are. */
    private static final int MOST_TOLD = 4;

    private final Notices notices;
    private final Texts texts;

    PovExport(Notices notices, Texts texts) {
        this.notices = notices;
        this.texts = texts;
    }

    /** @param folder where the files lie that the scene needs, if that is known */
    void write(Scene scene, Assets assets, Optional<Path> folder, Path target) {
        Background.run("paprsek-export", () -> written(scene, assets, folder, target), differences -> told(target, differences),
                fault -> notices.wrong(fault instanceof IOException unwritable ? Failures.sentence(target.toString(), unwritable) : target + ": " + fault.getMessage()));
    }

    private static List<String> written(Scene scene, Assets assets, Optional<Path> folder, Path target) throws IOException {
        Stream<String> missing = new Belongings(scene, assets, folder).take(target, true).stream().map(name -> name + " is missing, and is not taken along");
        return Stream.concat(missing, PovFiles.write(MeshFiles.read(scene, assets), target).stream()).toList();
    }

    private void told(Path target, List<String> differences) {
        notices.quiet();
        if (differences.isEmpty()) {
            notices.say(texts.of("file.exported", target.getFileName()));
            return;
        }
        notices.say("");
        String first = differences.stream().limit(MOST_TOLD).map(texts::sentence).collect(Collectors.joining("; "));
        int more = differences.size() - MOST_TOLD;
        notices.ask(texts.of("file.exported-but", target.getFileName(), more > 0 ? first + "; " + texts.of("file.exported-more", more) : first), List.of());
    }
}
