package cz.paprsek.xml;

import cz.paprsek.scene.Scene;
import jakarta.xml.bind.JAXBContext;
import jakarta.xml.bind.JAXBException;
import jakarta.xml.bind.Unmarshaller;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.transform.sax.SAXSource;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import org.jspecify.annotations.Nullable;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;

/** From a file to scenes: bound to beans by {@link Parse} and JAXB, of which the records are made, each of which may still refuse. */
final class SceneReader {
    private SceneReader() {}

    static List<Scene> read(InputStream input, String file) throws SceneFileException, IOException {
        BufferedInputStream buffered = new BufferedInputStream(new LimitedInput(input, file, SceneFiles.LARGEST));
        Prolog prolog = Prolog.of(buffered);
        return read(new InputSource(buffered), prolog, file);
    }

    /** As above; what the text says of its encoding does not matter, since it is a text already. */
    static List<Scene> read(String text, String file) throws SceneFileException, IOException {
        return read(new InputSource(new StringReader(text)), new Prolog(text), file);
    }

    private static List<Scene> read(InputSource input, Prolog prolog, String file) throws SceneFileException, IOException {
        Problems problems = new Problems(file);
        List<Scene> scenes = new ArrayList<>();
        try {
            Object root = bind(input, prolog, problems);
            List<SceneBean> beans = root instanceof DatabaseBean database ? database.scenes
                    : root instanceof SceneBean scene ? List.of(scene) : List.of();
            checkNames(root instanceof DatabaseBean database ? database.scenes : List.of(), problems);
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

    /** A scene of a database is found by its name. */
    private static void checkNames(List<SceneBean> scenes, Problems problems) {
        Set<String> names = new HashSet<>();
        for (SceneBean scene : scenes) {
            if (scene.name.isEmpty()) {
                problems.add(scene, "a scene in a database needs a name, to be found by");
            } else if (!names.add(scene.name)) {
                problems.add(scene, "there is already a scene named \"" + scene.name + "\"; give one of them another name");
            }
        }
    }

    /** The bean of the root element; null if that is wrong. */
    private static @Nullable Object bind(InputSource input, Prolog prolog, Problems problems) throws IOException {
        try {
            Unmarshaller unmarshaller = Shared.CONTEXT.createUnmarshaller();
            Parse parse = new Parse(Shared.SCHEMA.newValidatorHandler(), prolog, problems);
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
