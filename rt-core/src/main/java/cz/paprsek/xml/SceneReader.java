package cz.paprsek.xml;

import cz.paprsek.scene.Scene;
import jakarta.xml.bind.JAXBContext;
import jakarta.xml.bind.JAXBException;
import jakarta.xml.bind.Unmarshaller;
import jakarta.xml.bind.UnmarshallerHandler;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import javax.xml.validation.ValidatorHandler;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.XMLReader;

/** One parse of a file: parser → {@link Elements} → validator → binding, which is no longer fed once something is wrong. */
final class SceneReader {
    private SceneReader() {}

    static List<Scene> read(InputStream input, String file) throws SceneFileException, IOException {
        Problems problems = new Problems(file);
        Object root = bind(input, problems);
        problems.throwIfAny();
        List<SceneBean> beans = root instanceof DatabaseBean database ? database.scenes : List.of((SceneBean) root);
        List<Scene> scenes = new ArrayList<>(beans.size());
        for (SceneBean bean : beans) {
            Scene scene = bean.toScene(problems);
            if (scene != null) {
                scenes.add(scene);
            }
        }
        problems.throwIfAny();
        return scenes;
    }

    private static Object bind(InputStream input, Problems problems) throws IOException, SceneFileException {
        try {
            Unmarshaller unmarshaller = Shared.CONTEXT.createUnmarshaller();
            UnmarshallerHandler binding = unmarshaller.getUnmarshallerHandler();
            ValidatorHandler validator = Shared.SCHEMA.newValidatorHandler();
            Elements elements = new Elements(validator, problems);
            validator.setContentHandler(new BindingGate(binding, problems));
            validator.setErrorHandler(elements);
            unmarshaller.setListener(new Unmarshaller.Listener() {
                @Override
                public void beforeUnmarshal(Object target, Object parent) {
                    if (target instanceof Located located) {
                        located.line = elements.getLineNumber();
                        located.column = elements.getColumnNumber();
                    }
                }
            });
            XMLReader reader = hardened();
            reader.setContentHandler(elements);
            reader.setErrorHandler(elements);
            reader.setProperty("http://xml.org/sax/properties/lexical-handler", elements);
            parse(reader, input, elements, problems);
            problems.throwIfAny();
            return binding.getResult();
        } catch (JAXBException | SAXException | ParserConfigurationException e) {
            throw new IllegalStateException("the XML tools of this Java do not work as they should: " + e.getMessage(), e);
        }
    }

    private static void parse(XMLReader reader, InputStream input, Elements elements, Problems problems) throws IOException, SAXException {
        try {
            reader.parse(new InputSource(input));
        } catch (SAXParseException malformed) {
            elements.malformed(malformed);
        } catch (java.io.CharConversionException | java.io.UnsupportedEncodingException unreadable) {
            elements.unreadable();
        } catch (SAXException stopped) {
            if (!problems.isFull()) {
                throw stopped;
            }
        }
    }

    /** A parser that opens nothing but what it is given: no document type, no entities, no includes. */
    private static XMLReader hardened() throws ParserConfigurationException, SAXException {
        SAXParserFactory factory = SAXParserFactory.newInstance();
        factory.setNamespaceAware(true);
        factory.setXIncludeAware(false);
        factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
        factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
        factory.setFeature("http://xml.org/sax/features/external-general-entities", false);
        factory.setFeature("http://xml.org/sax/features/external-parameter-entities", false);
        return factory.newSAXParser().getXMLReader();
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
