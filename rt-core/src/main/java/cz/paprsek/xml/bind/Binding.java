package cz.paprsek.xml.bind;

import cz.paprsek.xml.format.SceneFormat;
import cz.paprsek.xml.mistake.Problems;
import jakarta.xml.bind.JAXBContext;
import jakarta.xml.bind.JAXBException;
import jakarta.xml.bind.Unmarshaller;
import java.io.IOException;
import java.io.StringReader;
import java.util.Objects;
import java.util.stream.Stream;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.transform.sax.SAXSource;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import org.jspecify.annotations.Nullable;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;

/** From a file to beans by {@link Parse} and JAXB. A class of its own: it cannot even be loaded where JAXB is missing. */
final class Binding {
    private Binding() {}

    /** @throws LinkageError if a library is missing */
    static void prepare() {
        Objects.requireNonNull(Shared.CONTEXT);
    }

    /** The bean of the root element; null if that is wrong. */
    static @Nullable Object root(InputSource input, Runnable found, Prolog prolog, Problems problems) throws IOException {
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
                return factory.newSchema(new StreamSource(new StringReader(SceneFormat.schema())));
            } catch (SAXException e) {
                throw new IllegalStateException("the schema in the program's own jar is damaged", e);
            }
        }

        private static JAXBContext context() {
            try {
                return JAXBContext.newInstance(Stream.concat(Stream.of(SceneBean.class, DatabaseBean.class), ShapeBeans.all()).toArray(Class<?>[]::new));
            } catch (JAXBException e) {
                throw new IllegalStateException("the annotated beans are at odds with JAXB", e);
            }
        }
    }
}
