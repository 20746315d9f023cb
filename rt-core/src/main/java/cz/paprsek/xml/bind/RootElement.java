package cz.paprsek.xml.bind;

import cz.paprsek.xml.format.SceneFormat;
import java.io.CharConversionException;
import java.io.IOException;
import java.io.InputStream;
import java.io.UnsupportedEncodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.xml.parsers.ParserConfigurationException;
import org.xml.sax.Attributes;
import org.xml.sax.SAXException;
import org.xml.sax.helpers.DefaultHandler;

/** Looks at the first element of a file and no further. Not with the platform's pulling reader, which tells faults to standard error, too. */
public final class RootElement extends DefaultHandler {
    private final String element;

    private RootElement(String element) {
        this.element = element;
    }

    /** Whether it is this one; not if the file is no XML. */
    public static boolean is(String element, Path file) throws IOException {
        try (InputStream input = Files.newInputStream(file)) {
            Parse.hardened().parse(input, new RootElement(element));
            return false;
        } catch (Found found) {
            return found.isWanted;
        } catch (CharConversionException | UnsupportedEncodingException | SAXException notXml) {
            return false;
        } catch (ParserConfigurationException e) {
            throw new IllegalStateException(e);
        }
    }

    @Override
    public void startElement(String uri, String localName, String qName, Attributes attributes) throws SAXException {
        throw new Found(localName.equals(element) && SceneFormat.NAMESPACE.equals(uri));
    }

    /** Ends the parse. */
    private static final class Found extends SAXException {
        private static final long serialVersionUID = 1L;
        private final boolean isWanted;

        Found(boolean isWanted) {
            this.isWanted = isWanted;
        }
    }
}
