package cz.paprsek.xml;

import cz.paprsek.io.PlainText;
import java.util.ArrayList;
import java.util.List;
import javax.xml.validation.ValidatorHandler;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.ext.DefaultHandler2;
import org.xml.sax.helpers.AttributesImpl;

/**
 * Stands between the parser and the validator: knows which elements are open and where the current one starts, limits nesting, and hears of
 * everything that is wrong. As a locator it gives the place of the current element's {@code <}; the parser itself gives that of its {@code >}.
 */
final class Elements extends DefaultHandler2 implements Locator {
    private static final Attributes NO_ATTRIBUTES = new AttributesImpl();

    private final ValidatorHandler next;
    private final Problems problems;
    private final List<String> path = new ArrayList<>();
    /** Line and column of every open element. */
    private final int[] starts = new int[2 * SceneFiles.DEEPEST];
    private Attributes attributes = NO_ATTRIBUTES;
    private @Nullable Complaints complaints;
    private @Nullable Locator parser;
    private int line = 1;
    private int column = 1;
    /** Where the piece of the file that comes next begins. */
    private int nextLine = 1;
    private int nextColumn = 1;

    Elements(ValidatorHandler next, Problems problems) {
        this.next = next;
        this.problems = problems;
    }

    @Override
    public void setDocumentLocator(Locator locator) {
        parser = locator;
        next.setDocumentLocator(this);
    }

    @Override
    public void startDocument() throws SAXException {
        next.startDocument();
    }

    @Override
    public void endDocument() throws SAXException {
        next.endDocument();
    }

    @Override
    public void startPrefixMapping(String prefix, String uri) throws SAXException {
        next.startPrefixMapping(prefix, uri);
    }

    @Override
    public void endPrefixMapping(String prefix) throws SAXException {
        next.endPrefixMapping(prefix);
    }

    @Override
    public void startElement(String uri, String localName, String qName, Attributes found) throws SAXException {
        line = nextLine;
        column = nextColumn;
        path.add(localName);
        attributes = found;
        if (path.size() > SceneFiles.DEEPEST) {
            throw new SAXParseException("elements are nested deeper than " + SceneFiles.DEEPEST, null, null, line, column);
        }
        starts[2 * path.size() - 2] = line;
        starts[2 * path.size() - 1] = column;
        next.startElement(uri, localName, qName, found);
        attributes = NO_ATTRIBUTES;
        advance();
    }

    @Override
    public void endElement(String uri, String localName, String qName) throws SAXException {
        // What is found missing at the end of an element is told at its start.
        line = starts[2 * path.size() - 2];
        column = starts[2 * path.size() - 1];
        next.endElement(uri, localName, qName);
        path.remove(path.size() - 1);
        advance();
    }

    @Override
    public void characters(char[] text, int start, int length) throws SAXException {
        next.characters(text, start, length);
        advance();
        // The parser has already taken the < that ends the text.
        nextColumn = Math.max(1, nextColumn - 1);
    }

    @Override
    public void ignorableWhitespace(char[] text, int start, int length) throws SAXException {
        characters(text, start, length);
    }

    @Override
    public void comment(char[] text, int start, int length) {
        advance();
    }

    @Override
    public void processingInstruction(String target, String data) {
        advance();
    }

    private void advance() {
        if (parser != null) {
            nextLine = parser.getLineNumber();
            nextColumn = parser.getColumnNumber();
        }
    }

    @Override
    public void error(SAXParseException e) throws SAXException {
        if (path.isEmpty()) {
            throw e;
        }
        if (complaints == null) {
            complaints = new Complaints(problems);
        }
        complaints.add(String.valueOf(e.getMessage()), path, attributes, line, column);
        if (problems.isFull()) {
            throw new SAXException("enough");
        }
    }

    /** The file is no XML, or not in the form we take. */
    void malformed(SAXParseException e) {
        String message = String.valueOf(e.getMessage());
        String inside = path.isEmpty() ? "" : path.get(path.size() - 1);
        int at = Math.max(1, e.getLineNumber());
        int where = Math.max(1, e.getColumnNumber());
        if (message.startsWith("elements are nested")) {
            problems.add(at, where, message);
        } else if (message.contains("DOCTYPE")) {
            problems.add(at, where, "a DOCTYPE is not allowed in a scene file; remove it");
        } else if (path.isEmpty()) {
            problems.add(at, where, "this is not a scene file: it should start with <scene xmlns=\"" + SceneFiles.NAMESPACE + "\">");
        } else {
            problems.add(at, where, "this is not well-formed XML, within <" + inside + ">, or the file is cut off: " + PlainText.of(message, 240));
        }
    }

    /** The bytes of the file are no text in the encoding that it claims. */
    void unreadable() {
        problems.add(nextLine, nextColumn, "this is not text in the encoding the file claims to have; save it as UTF-8");
    }

    @Override
    public int getLineNumber() {
        return line;
    }

    @Override
    public int getColumnNumber() {
        return column;
    }

    @Override
    public @Nullable String getPublicId() {
        return null;
    }

    @Override
    public @Nullable String getSystemId() {
        return null;
    }
}
