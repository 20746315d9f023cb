package cz.paprsek.cli.output;

import cz.paprsek.cli.input.FrameWishes;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.OutputFormat;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.film.FilmWriter;
import java.util.Optional;

/**
 * What becomes of the frames of a film that are wished for, if any are.
 *
 * @param film the format of the one file that they all go to; none if each is a picture of its own
 */
public record Reel(FrameWishes wishes, Optional<FilmWriter.Format> film) {
    private static final String STANDARD_OUTPUT = "-";

    /** @throws WrongUsage if a film is to be written, but nobody says of which frames */
    public static Reel of(FrameWishes wishes, Optional<String> output, Optional<OutputFormat> format) {
        Optional<FilmWriter.Format> film = format.isPresent() ? format.get().film() : output.flatMap(FilmWriter.Format::ofFile);
        if (film.isPresent() && wishes.frames().isEmpty()) {
            throw new WrongUsage(film.get().extension() + " is a film; say of which frames, such as --frames 1-100");
        }
        if (wishes.frames().isEmpty() && output.filter(name -> name.contains(Target.FRAME)).isPresent()) {
            throw new WrongUsage(Target.FRAME + " is the number of a frame; say which, such as --frames 1-100");
        }
        return new Reel(wishes, film);
    }

    /** Where pictures go, with a place for the number of the frame, or the film. */
    public Optional<String> output(Optional<String> given, Targets plain) {
        if (wishes.frames().isEmpty() || (wishes.isOne() && film.isEmpty()) || given.equals(Optional.of(STANDARD_OUTPUT))) {
            return given;
        }
        return film.isPresent() ? Optional.of(place(given, plain, "", film.get().extension())) : Optional.of(numbered(given, plain));
    }

    /** Where pictures of frames go, with a place for the number of the frame. */
    public static String numbered(Optional<String> given, Targets plain) {
        return given.filter(name -> name.contains(Target.FRAME)).orElseGet(
                () -> place(given, plain, "-" + Target.FRAME, plain.format().orElse(plain.raw() ? ImageFormat.RAW : ImageFormat.PNG).extension()));
    }

    private static String place(Optional<String> given, Targets plain, String number, String extension) {
        if (given.isEmpty() || plain.isDirectory()) {
            String folder = given.orElse("");
            return folder + (folder.isEmpty() || folder.endsWith("/") ? "" : "/") + Targets.NAME + number + "." + extension;
        }
        String file = given.get();
        int dot = file.lastIndexOf('.') > file.lastIndexOf('/') ? file.lastIndexOf('.') : file.length();
        return file.substring(0, dot) + number + file.substring(dot);
    }

    /** The format of the pictures. */
    public Optional<ImageFormat> pictures(Optional<OutputFormat> format) {
        return film.isPresent() ? Optional.of(ImageFormat.PNG) : format.flatMap(OutputFormat::picture);
    }
}
