package cz.paprsek.xml;

import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles.Contents;
import jakarta.xml.bind.JAXBContext;
import jakarta.xml.bind.JAXBException;
import jakarta.xml.bind.Unmarshaller;
import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
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
    private SceneReader() {}

    /** What a source is heard by on its way to a reader; asked for each reader anew. */
    interface Listening {
        InputStream to(InputStream input) throws IOException;
    }

    static Contents read(Path file, ReadMonitor monitor) throws SceneFileException, IOException {
        try (Source source = Source.of(file)) {
            long size = source.size();
            return read(source, input -> new WatchedInput(input, size, monitor), file.toString());
        }
    }

    static Contents read(InputStream input, String file) throws SceneFileException, IOException {
        return read(Source.of(input), heard -> heard, file);
    }

    /** The stream that was listened to last is read to its end. */
    static Contents read(Source source, Listening listening, String file) throws SceneFileException, IOException {
        InputStream first = new LimitedInput(listening.to(source.fromStart()), file, SceneFiles.LARGEST);
        Optional<Contents> contents = QuickReader.read(first);
        if (contents.isPresent()) {
            first.transferTo(OutputStream.nullOutputStream());
            return contents.get();
        }
        InputStream second = new LimitedInput(listening.to(source.fromStart()), file, SceneFiles.LARGEST);
        Contents found = thoroughly(second, file);
        second.transferTo(OutputStream.nullOutputStream());
        return found;
    }

    /** As above; what the text says of its encoding does not matter, since it is a text already. */
    static Contents read(String given, String file) throws SceneFileException, IOException {
        String text = given.startsWith("\uFEFF") ? given.substring(1) : given;
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        // Halves of characters, which no bytes stand for, are told apart from question marks.
        Optional<Contents> contents = new String(bytes, StandardCharsets.UTF_8).equals(text)
                ? QuickReader.read(new ByteArrayInputStream(bytes)) : Optional.empty();
        return contents.isPresent() ? contents.get() : read(new InputSource(new StringReader(text)), () -> {}, new Prolog(text), file);
    }

    /** Without the quick reader. */
    static Contents thoroughly(InputStream input, String file) throws SceneFileException, IOException {
        BufferedInputStream buffered = new BufferedInputStream(input);
        Prolog prolog = Prolog.of(buffered);
        PieceInput pieces = new PieceInput(buffered);
        return read(new InputSource(pieces), pieces::found, prolog, file);
    }

    private static Contents read(InputSource input, Runnable found, Prolog prolog, String file) throws SceneFileException, IOException {
        Problems problems = new Problems(file);
        List<Scene> scenes = new ArrayList<>();
        boolean isDatabase = false;
        try {
            Object root = bind(input, found, prolog, problems);
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
        problems.throwIfAny();
        return new Contents(scenes, isDatabase);
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
