package cz.paprsek.xml.bind;

import cz.paprsek.scene.Scene;
import cz.paprsek.xml.format.FileScenes;
import cz.paprsek.xml.mistake.Mistake;
import cz.paprsek.xml.mistake.Problems;
import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.CharConversionException;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.io.UnsupportedEncodingException;
import java.util.ArrayList;
import java.util.List;
import javax.xml.parsers.ParserConfigurationException;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.helpers.DefaultHandler;

/** Has any file bound to beans, and makes the records of them, each of which may still refuse. */
public final class ThoroughReader {
    private ThoroughReader() {}

    /**
     * What came of reading.
     *
     * @param scenes some are missing if there are mistakes
     * @param mistakes all there are, in the order of the file
     */
    public record Outcome(FileScenes scenes, List<Mistake> mistakes) {
        public Outcome {
            mistakes = List.copyOf(mistakes);
        }
    }

    /**
     * Reads a file of any encoding.
     *
     * @param file its name, for messages
     * @throws IOException if it cannot be read, or JAXB is missing
     */
    public static Outcome read(InputStream input, String file) throws IOException {
        BufferedInputStream buffered = new BufferedInputStream(input);
        Prolog prolog = Prolog.of(buffered);
        PieceInput pieces = new PieceInput(buffered);
        return read(new InputSource(pieces), pieces::found, prolog, file);
    }

    /** As above; what the text says of its encoding does not matter, since it is a text already. */
    public static Outcome read(String text, String file) throws IOException {
        return read(new InputSource(new StringReader(text)), () -> {}, new Prolog(text), file);
    }

    /** Whether it is XML, whatever it says. */
    public static boolean isWellFormed(byte[] file) throws IOException {
        try {
            Parse.hardened().parse(new ByteArrayInputStream(file), new DefaultHandler());
            return true;
        } catch (SAXException | CharConversionException | UnsupportedEncodingException malformed) {
            return false;
        } catch (ParserConfigurationException e) {
            throw new IllegalStateException("the XML tools of this Java do not work as they should: " + e, e);
        }
    }

    private static Outcome read(InputSource input, Runnable found, Prolog prolog, String file) throws IOException {
        Libraries.require(file);
        Problems problems = new Problems();
        List<Scene> scenes = new ArrayList<>();
        boolean isDatabase = false;
        try {
            Object root = Binding.root(input, found, prolog, problems);
            List<SceneBean> beans = root instanceof DatabaseBean database ? database.scenes
                    : root instanceof SceneBean scene ? List.of(scene) : List.of();
            if (root instanceof DatabaseBean database) {
                isDatabase = true;
                beans.forEach(scene -> database.checkName(scene, problems));
            }
            for (SceneBean bean : beans) {
                Scene scene = bean.toScene(problems);
                if (scene != null) {
                    scenes.add(scene);
                }
            }
        } catch (Problems.Stop enough) {
            // What there is to tell stands in the problems.
        }
        return new Outcome(new FileScenes(scenes, isDatabase), problems.inOrder());
    }
}
