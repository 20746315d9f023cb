package cz.paprsek.xml;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.xml.SceneFiles.Contents;
import cz.paprsek.xml.text.FileText;
import cz.paprsek.xml.text.Form;
import cz.paprsek.xml.text.Unpatchable;
import cz.paprsek.xml.write.SceneForms;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The bytes of a file and the scenes in it. What others the file is to have is written into these bytes, and all else stays. */
final class OriginalText {
    /**
     * How deep elements are changed piece by piece: all the way; if that went wrong, those directly inside a scene or a database are written anew.
     * At last the whole file is.
     */
    private static final int[] DEPTHS = {SceneFiles.DEEPEST + 1, 2, 1};

    private final byte[] bytes;
    private final Contents contents;

    private OriginalText(byte[] bytes, Contents contents) {
        this.bytes = bytes;
        this.contents = contents;
    }

    static OriginalText read(Path path, ReadMonitor monitor) throws SceneFileException, IOException {
        SceneFiles.checkReadable(path);
        byte[] bytes;
        try (InputStream input = new LimitedInput(Files.newInputStream(path), path.toString(), SceneFiles.LARGEST)) {
            bytes = input.readAllBytes();
        }
        return new OriginalText(bytes, SceneReader.read(Source.of(bytes), input -> new WatchedInput(input, bytes.length, monitor), path.toString()));
    }

    /** The text of a new file. */
    static OriginalText of(Scene scene) {
        return new OriginalText(SceneFiles.format(scene).getBytes(StandardCharsets.UTF_8), new Contents(List.of(scene), false));
    }

    byte[] bytes() {
        return bytes;
    }

    Contents contents() {
        return contents;
    }

    /**
     * The file with other scenes.
     *
     * @throws IllegalArgumentException if these cannot be written, as {@link SceneFiles#format} and {@link SceneFiles#formatAll}
     */
    byte[] with(List<Scene> wanted) {
        if (contents.isDatabase()) {
            SceneDatabase.of(wanted);
        }
        Optional<FileText> text = text();
        for (int depth : DEPTHS) {
            Optional<byte[]> patched = text.flatMap(original -> patched(original, wanted, depth));
            if (patched.isPresent()) {
                return patched.get();
            }
        }
        return (contents.isDatabase() ? SceneFiles.formatAll(wanted) : SceneFiles.format(wanted.get(0))).getBytes(StandardCharsets.UTF_8);
    }

    private Optional<FileText> text() {
        try {
            return Optional.of(new FileText(bytes));
        } catch (Unpatchable e) {
            return Optional.empty();
        }
    }

    /** The changed text; empty if it does not say what it should. */
    Optional<byte[]> patched(FileText text, List<Scene> wanted, int depth) {
        List<Form> forms = wanted.stream().map(SceneForms::scene).toList();
        Form before = contents.isDatabase() ? SceneForms.database(contents.scenes().stream().map(SceneForms::scene).toList()) : SceneForms.file(contents.scenes().get(0));
        Form now = contents.isDatabase() ? SceneForms.database(forms) : SceneForms.file(wanted.get(0));
        try {
            FileText.Changed changed = text.changed(before, now, depth);
            List<Scene> inSample = new ArrayList<>();
            for (int i = 0; i < forms.size(); i++) {
                if (!changed.leftOut().contains(forms.get(i))) {
                    inSample.add(wanted.get(i));
                }
            }
            boolean isGood = changed.whole() == bytes || says(changed.sample(), inSample);
            return isGood ? Optional.of(changed.whole()) : Optional.empty();
        } catch (Unpatchable e) {
            return Optional.empty();
        }
    }

    private static boolean says(byte[] text, List<Scene> wanted) {
        try {
            return SceneReader.read(Source.of(text), input -> input, "text").scenes().equals(wanted);
        } catch (SceneFileException wrong) {
            return false;
        } catch (IOException e) {
            throw new IllegalStateException("bytes in memory could not be read", e);
        }
    }
}
