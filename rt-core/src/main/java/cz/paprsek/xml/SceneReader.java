package cz.paprsek.xml;

import cz.paprsek.scene.Scene;
import jakarta.xml.bind.JAXBContext;
import jakarta.xml.bind.JAXBException;
import jakarta.xml.bind.Unmarshaller;
import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.SequenceInputStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.transform.sax.SAXSource;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import org.jspecify.annotations.Nullable;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;

/**
 * From a file to scenes: by the {@link QuickReader} if it is good and plain. Else bound to beans by {@link Parse} and JAXB, of which the records are
 * made, each of which may still refuse: that takes six times as long, and tells every problem.
 */
final class SceneReader {
    /** How much of a stream is kept, in case that it must be read once more. */
    private static final int MOST_KEPT = 1 << 25;

    private SceneReader() {}

    static List<Scene> read(Path file, ReadMonitor monitor) throws SceneFileException, IOException {
        if (Files.isRegularFile(file)) {
            return read(() -> new WatchedInput(file, monitor), file.toString());
        }
        try (InputStream input = new WatchedInput(file, monitor)) {
            return read(input, file.toString());
        }
    }

    /** What can be read more than once, each time from its beginning. */
    interface Opening {
        InputStream open() throws IOException;
    }

    /** The last stream that was opened is read to its end. */
    static List<Scene> read(Opening opening, String file) throws SceneFileException, IOException {
        try (InputStream input = new LimitedInput(opening.open(), file, SceneFiles.LARGEST)) {
            Optional<List<Scene>> scenes = QuickReader.read(input);
            if (scenes.isPresent()) {
                input.transferTo(OutputStream.nullOutputStream());
                return scenes.get();
            }
        }
        try (InputStream input = new LimitedInput(opening.open(), file, SceneFiles.LARGEST)) {
            List<Scene> scenes = thoroughly(input, file);
            input.transferTo(OutputStream.nullOutputStream());
            return scenes;
        }
    }

    static List<Scene> read(InputStream input, String file) throws SceneFileException, IOException {
        InputStream limited = new LimitedInput(input, file, SceneFiles.LARGEST);
        byte[] start = limited.readNBytes(MOST_KEPT);
        Optional<List<Scene>> scenes = start.length == MOST_KEPT ? Optional.empty() : QuickReader.read(new ByteArrayInputStream(start));
        return scenes.isPresent() ? scenes.get()
                : thoroughly(new SequenceInputStream(new ByteArrayInputStream(start), limited), file);
    }

    /** As above; what the text says of its encoding does not matter, since it is a text already. */
    static List<Scene> read(String text, String file) throws SceneFileException, IOException {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        // Halves of characters, which no bytes stand for, are told apart from question marks.
        Optional<List<Scene>> scenes = new String(bytes, StandardCharsets.UTF_8).equals(text)
                ? QuickReader.read(new ByteArrayInputStream(bytes)) : Optional.empty();
        return scenes.isPresent() ? scenes.get() : read(new InputSource(new StringReader(text)), () -> {}, new Prolog(text), file);
    }

    /** Without the quick reader. */
    static List<Scene> thoroughly(InputStream input, String file) throws SceneFileException, IOException {
        BufferedInputStream buffered = new BufferedInputStream(input);
        Prolog prolog = Prolog.of(buffered);
        PieceInput pieces = new PieceInput(buffered);
        return read(new InputSource(pieces), pieces::found, prolog, file);
    }

    private static List<Scene> read(InputSource input, Runnable found, Prolog prolog, String file) throws SceneFileException, IOException {
        Problems problems = new Problems(file);
        List<Scene> scenes = new ArrayList<>();
        try {
            Object root = bind(input, found, prolog, problems);
            List<SceneBean> beans = root instanceof DatabaseBean database ? database.scenes
                    : root instanceof SceneBean scene ? List.of(scene) : List.of();
            if (root instanceof DatabaseBean database) {
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
        problems.throwIfAny();
        return scenes;
    }

    /** The bean of the root element; null if that is wrong. */
    private static @Nullable Object bind(InputSource input, Runnable found, Prolog prolog, Problems problems) throws IOException {
        try {
            Unmarshaller unmarshaller = Shared.CONTEXT.createUnmarshaller();
            Parse parse = new Parse(Shared.SCHEMA.newValidatorHandler(), prolog, problems, found);
            unmarshaller.setListener(new Unmarshaller.Listener() {
                @Override
                public void beforeUnmarshal(Object target, Object parent) {
                    if (target instanceof Located located) {
                        parse.locate(located);
                    }
                }
            });
            return unmarshaller.unmarshal(new SAXSource(parse, input));
        } catch (JAXBException e) {
            if (e.getLinkedException() instanceof IOException unreadable) {
                throw unreadable;
            }
            throw broken(e);
        } catch (SAXException | ParserConfigurationException e) {
            throw broken(e);
        }
    }

    private static IllegalStateException broken(Exception e) {
        return new IllegalStateException("the XML tools of this Java do not work as they should: " + e, e);
    }

    /** What is costly to make, made when the first file is read. Both are safe to use from several threads. */
    private static final class Shared {
        static final Schema SCHEMA = schema();
        static final JAXBContext CONTEXT = context();

        private static Schema schema() {
            try {
                SchemaFactory factory = SchemaFactory.newInstance(XMLConstants.W3C_XML_SCHEMA_NS_URI);
                factory.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
                factory.setProperty(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
                return factory.newSchema(new StreamSource(new StringReader(SceneFiles.schema())));
            } catch (SAXException e) {
                throw new IllegalStateException("the schema in the program's own jar is damaged", e);
            }
        }

        private static JAXBContext context() {
            try {
                return JAXBContext.newInstance(SceneBean.class, DatabaseBean.class);
            } catch (JAXBException e) {
                throw new IllegalStateException("the annotated beans are at odds with JAXB", e);
            }
        }
    }
}
