package cz.paprsek.cli.bench;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.ImageComparison;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.StoredImage;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * What came of one scene rendered by us and by POV-Ray.
 *
 * @param warnings what POV-Ray is known not to show exactly
 */
record CrossCheck(StoredImage ours, StoredImage theirs, ImageComparison comparison, List<String> warnings) {

    /** Where POV-Ray's picture of a scene is recorded: beside it, as 16-bit linear PNG. */
    static Path recording(Path scene) {
        String name = String.valueOf(scene.getFileName());
        int dot = name.lastIndexOf('.');
        return scene.resolveSibling((dot > 0 ? name.substring(0, dot) : name) + ".png");
    }

    /**
     * Renders a scene with one ray a pixel, random points the same in every one, and compares it with POV-Ray's picture.
     *
     * @param live runs POV-Ray; if empty, its recorded picture is taken
     * @param record whether a picture made now is recorded
     * @throws IOException with one line that says why there is no picture of POV-Ray's
     */
    static CrossCheck of(Path file, Scene asked, Assets assets, Optional<PovRay> live, boolean record, double tolerance) throws IOException, InterruptedException {
        Scene scene = asked.withSettings(asked.settings().withSamples(1));
        if (live.isPresent() && record) {
            live.get().render(scene, assets, 1, recording(file));
        }
        StoredImage theirs = live.isPresent() && !record
                ? new StoredImage(live.get().render(scene, assets, 1).image(), Precision.SIXTEEN_BIT, false)
                : recorded(recording(file));
        StoredImage ours = StoredImage.of(Renderer.render(RenderScene.of(scene, assets, RenderMonitor.NONE), RenderOptions.of(scene).withFixedSampler(), RenderMonitor.NONE).image());
        return new CrossCheck(ours, theirs, ImageComparison.of(ours, theirs, tolerance), PovFiles.write(scene, new StringBuilder()));
    }

    private static StoredImage recorded(Path file) throws IOException {
        if (!Files.exists(file)) {
            throw new IOException("POV-Ray is not installed, and there is no recorded picture " + file);
        }
        StoredImage recorded = ImageFiles.readStored(file);
        if (recorded.precision() == Precision.EIGHT_BIT) {
            throw new IOException(file + " is not a recording of POV-Ray's: it has 8 bits, not 16");
        }
        return recorded;
    }
}
