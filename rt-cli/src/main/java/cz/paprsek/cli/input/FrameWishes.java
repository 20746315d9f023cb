package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.FrameRange;
import cz.paprsek.scene.Scene;
import java.util.Optional;
import picocli.CommandLine.Option;

/** Which frames of a film the user wants. */
public final class FrameWishes {
    @Option(names = "--frames", paramLabel = "A-B", description = {
        "Renders frames A to B of a film, the first being 1, as what moves in the scene has it at their times; without it the scene is as it is written.",
        "Each becomes a picture of its own, {frame} in the output being its number with zeros in front; or all of them a film, if the output ends in .apng, .gif or .y4m, or "
                + "--format says so: -o - --format y4m is for ffmpeg."})
    private Optional<FrameRange> frames = Optional.empty();

    @Option(names = "--frame", paramLabel = "N", description = "Renders frame N of the film that the scene is, to a picture as of any scene.")
    private Optional<Integer> frame = Optional.empty();

    @Option(names = "--fps", paramLabel = "N", description = "Frames a second: frame N shows the time (N - 1)/fps. Default: the scene's, which is 25 if it says none.")
    private Optional<Double> fps = Optional.empty();

    @Option(names = "--shutter", paramLabel = "SHARE", description = {
        "For which share of a frame's time, 0-1, light falls in: what moves is blurred. Each ray has an instant of its own, one of 128. Default: the scene's, which is 0 if it says none."})
    private Optional<Double> shutter = Optional.empty();

    /** Whether it is one, to a picture whose name needs no number. */
    public boolean isOne() {
        return frame.isPresent();
    }

    public Optional<FrameRange> frames() {
        if (frame.isPresent()) {
            if (frames.isPresent()) {
                throw new WrongUsage("--frame is for one, --frames for several; leave one of them away");
            }
            if (frame.get() < 1) {
                throw new WrongUsage("frames begin with 1, but here is " + frame.get());
            }
            return Optional.of(new FrameRange(frame.get(), frame.get()));
        }
        if (frames.isEmpty() && (fps.isPresent() || shutter.isPresent())) {
            throw new WrongUsage((fps.isPresent() ? "--fps" : "--shutter") + " is for frames of a film; say which, such as --frames 1-100");
        }
        return frames;
    }

    /** @throws WrongUsage if there cannot be so many frames a second, or the shutter cannot be open for so long */
    public Scene applyTo(Scene scene) {
        try {
            Scene timed = fps.isPresent() ? scene.withSettings(scene.settings().withFps(fps.get())) : scene;
            return shutter.isPresent() ? timed.withSettings(timed.settings().withShutter(shutter.get())) : timed;
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(String.valueOf(refused.getMessage()));
        }
    }
}
