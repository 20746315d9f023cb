package cz.paprsek.xml.bind;

import cz.paprsek.xml.mistake.Malformed;
import java.io.ByteArrayInputStream;
import java.io.CharConversionException;
import java.io.IOException;
import java.io.UnsupportedEncodingException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import javax.xml.parsers.ParserConfigurationException;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;

/** The elements of a small file that is no scene, whatever they mean. Nothing is opened but what it is given: no document type, no entities, no includes. */
public final class PlainElements extends DefaultHandler {
    private static final int DEEPEST = 100;

    private final Deque<Element> open = new ArrayDeque<>();
    private @Nullable Element root;
    private @Nullable Locator locator;

    private PlainElements() {}

    /**
     * An element with what is in it.
     *
     * @param namespace of its name; empty for none
     * @param line where its first tag ends, from 1
     * @param column likewise
     * @param attributes those without a namespace
     * @param text all that is not within an element of its own
     */
    public record Element(String namespace, String name, int line, int column, Map<String, String> attributes, List<Element> children, StringBuilder text) {}

    /** A file is no XML, or has what none of ours needs. */
    public static final class Refused extends Exception {
        private static final long serialVersionUID = 1;

        private final int line;
        private final int column;

        Refused(int line, int column, String sentence) {
            super(sentence);
            this.line = Math.max(1, line);
            this.column = Math.max(1, column);
        }

        /** Where, from 1. */
        public int line() {
            return line;
        }

        /** Where, from 1. */
        public int column() {
            return column;
        }
    }

    /**
     * The outermost element.
     *
     * @throws Refused with what is wrong, in one sentence
     */
    public static Element read(byte[] file) throws Refused, IOException {
        PlainElements reader = new PlainElements();
        try {
            if (file.length == 0) {
                throw new Refused(1, 1, "the file is empty");
            }
            Parse.hardened().parse(new ByteArrayInputStream(file), reader);
            return Objects.requireNonNull(reader.root);
        } catch (CharConversionException | UnsupportedEncodingException encoding) {
            throw new Refused(1, 1, "this is not text in the encoding that the file claims to have, or else UTF-8");
        } catch (SAXParseException malformed) {
            String theirs = String.valueOf(malformed.getMessage());
            throw new Refused(malformed.getLineNumber(), malformed.getColumnNumber(), theirs.contains("DOCTYPE") ? "there must be no DOCTYPE here; remove it"
                    : Malformed.isAboutEncoding(theirs) ? "this is not text in UTF-8; save it as UTF-8"
                    : Malformed.sentence(theirs, reader.open.isEmpty() ? "" : reader.open.getLast().name()));
        } catch (SAXException e) {
            throw new Refused(1, 1, "this is not well-formed XML");
        } catch (ParserConfigurationException e) {
            throw new IllegalStateException("the XML tools of this Java do not work as they should: " + e, e);
        }
    }

    @Override
    public void setDocumentLocator(Locator where) {
        locator = where;
    }

    @Override
    public void startElement(String namespace, String name, String qualified, Attributes given) throws SAXException {
        Locator at = Objects.requireNonNull(locator);
        if (open.size() >= DEEPEST) {
            throw new SAXParseException("too deep", at);
        }
        Map<String, String> attributes = new LinkedHashMap<>();
        for (int i = 0; i < given.getLength(); i++) {
            if (given.getURI(i).isEmpty()) {
                attributes.put(given.getLocalName(i), given.getValue(i));
            }
        }
        Element element = new Element(namespace, name, at.getLineNumber(), at.getColumnNumber(), attributes, new ArrayList<>(), new StringBuilder());
        if (open.isEmpty()) {
            root = element;
        } else {
            open.getLast().children().add(element);
        }
        open.addLast(element);
    }

    @Override
    public void characters(char[] text, int from, int length) {
        open.getLast().text().append(text, from, length);
    }

    @Override
    public void endElement(String namespace, String name, String qualified) {
        open.removeLast();
    }

    @Override
    public void fatalError(SAXParseException e) throws SAXException {
        throw e;
    }
}
