package cz.paprsek.xml;

import cz.paprsek.asset.Assets;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import cz.paprsek.xml.SceneFiles.Contents;
import cz.paprsek.xml.bind.ThoroughReader;
import cz.paprsek.xml.format.FileScenes;
import cz.paprsek.xml.mistake.Mistake;
import cz.paprsek.xml.quick.PlainMarkup;
import cz.paprsek.xml.quick.QuickReader;
import cz.paprsek.xml.recipe.IncludedFiles;
import cz.paprsek.xml.recipe.Moment;
import cz.paprsek.xml.recipe.Script;
import cz.paprsek.xml.recipe.Script.Wrong;
import cz.paprsek.xml.text.Encoding;
import cz.paprsek.xml.text.Unpatchable;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * How scenes are made of files that have parameters, formulas, repetition and the like: they are written out, and read as all others.
 *
 * @param parameters values in place of those that the file gives, by name
 * @param moment the time that formulas know
 * @param files what may be included
 */
record Making(Map<String, String> parameters, Moment moment, IncludedFiles files) {
    /** How long such a file may be, in bytes. */
    static final int LONGEST = 1 << 24;
    /** As the file says, with no files beside it. */
    static final Making PLAIN = from(Assets.none(), Map.of());

    private static final Pattern NUMBER_OR_TEXT = Pattern.compile("\"[^\"]*\"|[-.0-9]+");

    Making {
        parameters = Map.copyOf(parameters);
    }

    /** Of a picture at rest. */
    Making(Map<String, String> parameters, IncludedFiles files) {
        this(parameters, Moment.REST, files);
    }

    /** With the files that a scene may name. */
    static Making from(Assets assets, Map<String, String> parameters) {
        return new Making(parameters, new IncludedFiles() {
            @Override
            public byte[] read(String name) throws IOException {
                ByteBuffer found = assets.bytes(name);
                byte[] bytes = new byte[found.remaining()];
                found.get(bytes);
                return utf8(bytes, name);
            }

            @Override
            public Optional<String> called(String name) {
                return assets.called(name);
            }
        });
    }

    /** As a scene that has been read was made. */
    static Making of(Recipe recipe, Map<String, String> parameters) {
        return of(recipe, parameters, Moment.REST);
    }

    /** As the other, at another time. */
    static Making of(Recipe recipe, Map<String, String> parameters, Moment moment) {
        return new Making(parameters, moment, name -> {
            String text = recipe.included().get(name);
            if (text == null) {
                throw new IOException("\"" + name + "\" is not among the files that the scene was made of");
            }
            return text.getBytes(StandardCharsets.UTF_8);
        });
    }

    private static byte[] utf8(byte[] file, String name) throws IOException {
        if (!isWellFormed(file)) {
            throw new IOException("\"" + name + "\" is no XML; what is wrong with it, validate tells");
        }
        try {
            return Encoding.of(file).toUtf8(file);
        } catch (Unpatchable unknown) {
            throw new IOException("\"" + name + "\": " + unknown.getMessage(), unknown);
        }
    }

    /** As for plain files, the parser of the Java platform is for unusual ones. */
    private static boolean isWellFormed(byte[] file) throws IOException {
        return PlainMarkup.isIn(file) || ThoroughReader.isWellFormed(file);
    }

    /** What is in a file; empty if there is nothing in it that must be made. */
    Optional<Contents> contents(byte[] file, String name) throws SceneFileException, IOException {
        byte[] utf8;
        try {
            utf8 = Encoding.of(file).toUtf8(file);
        } catch (Unpatchable unknown) {
            return Optional.empty();
        }
        if (!mayMake(utf8) || !isWellFormed(file)) {
            return Optional.empty();
        }
        Optional<Script> script = Script.of(utf8, name, parameters, moment, files, SceneFiles.LARGEST);
        return script.isEmpty() ? Optional.empty() : Optional.of(contents(script.get(), name));
    }

    /** Whether a file may have anything that must be made; if not, it is as all others. */
    boolean mayMake(byte[] utf8) {
        return !parameters.isEmpty() || Script.mayBeIn(utf8);
    }

    static Contents contents(Script script, String name) throws SceneFileException, IOException {
        refuse(script.mistakes());
        byte[] text = script.text();
        Optional<FileScenes> quick = QuickReader.read(new ByteArrayInputStream(text));
        FileScenes found = quick.isPresent() ? quick.get() : thorough(script, text, name);
        List<Scene> scenes = new ArrayList<>();
        for (Scene scene : found.scenes()) {
            scenes.add(scene.withRecipe(script.recipes().get(scenes.size())));
        }
        return new Contents(scenes, found.isDatabase());
    }

    private static FileScenes thorough(Script script, byte[] text, String name) throws SceneFileException, IOException {
        ThoroughReader.Outcome outcome = ThoroughReader.read(new ByteArrayInputStream(text), name);
        List<Wrong> wrong = new ArrayList<>();
        for (Mistake one : outcome.mistakes()) {
            wrong.add(script.wrong(one.line(), one.message(), one.attributes()));
        }
        refuse(wrong);
        return outcome.scenes();
    }

    private static void refuse(List<Wrong> wrong) throws SceneFileException {
        // What is wrong with a copy is wrong with all.
        Map<String, Problem> problems = new LinkedHashMap<>();
        for (Wrong one : wrong) {
            String kind = one.file() + ':' + one.line() + ':' + one.column() + NUMBER_OR_TEXT.matcher(one.message()).replaceAll("");
            problems.putIfAbsent(kind, new Problem(one.file(), one.line(), one.column(), one.message()));
        }
        if (!problems.isEmpty()) {
            throw new SceneFileException(problems.values().stream().sorted(Comparator.comparing(Problem::file).thenComparingInt(Problem::line)
                    .thenComparingInt(Problem::column)).toList());
        }
    }
}
