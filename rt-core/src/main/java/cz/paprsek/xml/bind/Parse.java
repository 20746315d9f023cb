package cz.paprsek.xml.bind;

import cz.paprsek.xml.mistake.Malformed;
import cz.paprsek.xml.mistake.Problems;
import java.io.CharConversionException;
import java.io.IOException;
import java.io.UnsupportedEncodingException;
import java.util.Locale;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParser;
import javax.xml.parsers.SAXParserFactory;
import javax.xml.validation.ValidatorHandler;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.XMLFilterImpl;

/**
 * The one parse of a file: parser → {@link Elements} → validator → {@link BindingGate} → binding. To JAXB it looks like a parser, because JAXB
 * interns every name once more when it is fed in any other way.
 */
final class Parse extends XMLFilterImpl {
    private final ValidatorHandler validator;
    private final Elements elements;
    private final Problems problems;
    private final Prolog prolog;

    Parse(ValidatorHandler validator, Prolog prolog, Problems problems, Runnable found) throws ParserConfigurationException, SAXException {
        super(hardened().getXMLReader());
        this.validator = validator;
        this.prolog = prolog;
        this.problems = problems;
        elements = new Elements(validator, prolog, problems, found);
        validator.setProperty("http://apache.org/xml/properties/locale", Locale.ROOT);
        validator.setErrorHandler(elements);
    }

    /** Notes that an object is made from the current element. */
    void locate(Located bean) {
        bean.line = elements.getLineNumber();
        bean.column = elements.getColumnNumber();
    }

    /** @throws Problems.Stop if the file is no XML, or has problems enough */
    @Override
    public void parse(InputSource input) throws IOException {
        try {
            validator.setContentHandler(new BindingGate(getContentHandler(), problems));
            getParent().setContentHandler(elements);
            getParent().setErrorHandler(elements);
            getParent().setProperty("http://xml.org/sax/properties/lexical-handler", elements);
            getParent().parse(input);
        } catch (SAXParseException e) {
            String theirs = String.valueOf(e.getMessage());
            if (Malformed.isAboutEncoding(theirs)) {
                wrongEncoding(e.getLineNumber(), e.getColumnNumber());
            }
            elements.malformed(theirs, e.getLineNumber(), e.getColumnNumber());
        } catch (PieceInput.TooLong e) {
            elements.endless(String.valueOf(e.getMessage()));
        } catch (UnsupportedEncodingException e) {
            wrongEncoding(1, 1);
        } catch (CharConversionException e) {
            wrongEncoding(elements.getLineNumber(), elements.getColumnNumber());
        } catch (SAXException e) {
            // The parser loses itself in some texts, such as a DOCTYPE behind a <!, and then says neither where nor why.
            elements.malformed(String.valueOf(e.getMessage()), elements.getLineNumber(), elements.getColumnNumber());
        }
    }

    private void wrongEncoding(int line, int column) {
        problems.add(Math.max(1, line), Math.max(1, column), prolog.wrongEncoding());
        throw new Problems.Stop();
    }

    /** A parser that opens nothing but what it is given: no document type, no entities, no includes. */
    static SAXParser hardened() throws ParserConfigurationException, SAXException {
        SAXParserFactory factory = SAXParserFactory.newInstance();
        factory.setNamespaceAware(true);
        factory.setXIncludeAware(false);
        factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
        factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
        factory.setFeature("http://xml.org/sax/features/external-general-entities", false);
        factory.setFeature("http://xml.org/sax/features/external-parameter-entities", false);
        SAXParser parser = factory.newSAXParser();
        speakEnglish(parser);
        // The limit of elements nested is ours, and told in our words; that of the parser differs from JDK to JDK.
        parser.setProperty("http://www.oracle.com/xml/jaxp/properties/maxElementDepth", "0");
        return parser;
    }

    /**
     * Messages are told apart by their English text, which the tables without a language have. Asked for {@link Locale#ENGLISH}, Java finds no
     * table of that name and takes the one of the machine's language.
     */
    @SuppressWarnings("deprecation") // The only way there is to a parser's language.
    private static void speakEnglish(SAXParser parser) throws SAXException {
        parser.getParser().setLocale(Locale.ROOT);
    }
}
