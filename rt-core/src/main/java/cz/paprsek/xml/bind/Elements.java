package cz.paprsek.xml.bind;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.format.SceneFormat;
import cz.paprsek.xml.mistake.Complaints;
import cz.paprsek.xml.mistake.Malformed;
import cz.paprsek.xml.mistake.Problems;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.xml.validation.ValidatorHandler;
import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.ext.DefaultHandler2;
import org.xml.sax.helpers.AttributesImpl;

/**
 * Stands between the parser and the validator: knows which elements are open and where the current one starts, sets limits, and hears of
 * everything that is wrong. As a locator it gives the place of the current tag's {@code <}; the parser itself gives that of its {@code >}.
 */
final class Elements extends DefaultHandler2 implements Locator {
    /** The longest value of an attribute: longer than any that means something, short enough to be checked in no time. */
    private static final int LONGEST_VALUE = 100_000;
    /** The longest text that is handed on; far longer than any that may be kept. */
    private static final int LONGEST_TEXT = 1_000_000;
    private static final Set<String> AT_MOST_ONCE = Stream.concat(Described.elements(Scene.class).stream().map(Described::name),
            Arrays.stream(Scene.class.getRecordComponents()).map(RecordComponent::getType).filter(type -> type.isAnnotationPresent(Element.class)).map(ElementTable::name))
            .collect(Collectors.toUnmodifiableSet());
    private static final Attributes NO_ATTRIBUTES = new AttributesImpl();

    private final ValidatorHandler next;
    private final Prolog prolog;
    private final Problems problems;
    /** Told of everything that is found. */
    private final Runnable found;
    /** Local names; those of another namespace than ours after that namespace in braces. */
    private final List<String> path = new ArrayList<>();
    /** Line and column where each open element starts, and the problems there were before it. */
    private final int[] lines = new int[SceneFormat.DEEPEST + 1];
    private final int[] columns = new int[SceneFormat.DEEPEST + 1];
    private final int[] problemsBefore = new int[SceneFormat.DEEPEST + 1];
    /** Of {@link #AT_MOST_ONCE}, what the scene at hand has had. */
    private final Set<String> once = new HashSet<>();
    private Attributes attributes = NO_ATTRIBUTES;
    private @Nullable Complaints complaints;
    private @Nullable Locator parser;
    private int line = 1;
    private int column = 1;
    /** Where the piece of the file that comes next begins. */
    private int nextLine;
    private int nextColumn;
    /** Whether the text at hand has been told to be out of place: the parser hands it over in pieces. */
    private boolean isTextTold;
    /** Characters since the last tag, of a description or of text out of place. */
    private int textLength;
    /** Whether the root has been closed. */
    private boolean isOver;

    Elements(ValidatorHandler next, Prolog prolog, Problems problems, Runnable found) {
        this.next = next;
        this.found = found;
        this.prolog = prolog;
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
    public void startElement(String uri, String localName, String qName, Attributes given) throws SAXException {
        line = path.isEmpty() ? prolog.rootLine() : nextLine;
        column = path.isEmpty() ? prolog.rootColumn() : nextColumn;
        path.add(uri.equals(SceneFormat.NAMESPACE) ? localName : "{" + uri + "}" + localName);
        attributes = given;
        setLimits(given);
        isTextTold = false;
        textLength = 0;
        lines[path.size()] = line;
        columns[path.size()] = column;
        problemsBefore[path.size()] = problems.size();
        count(localName);
        if (complaints != null) {
            complaints.addIfUnknown(path, line, column);
        }
        next.startElement(uri, localName, qName, given);
        attributes = NO_ATTRIBUTES;
        advance();
    }

    private void count(String element) {
        if (element.equals("scene")) {
            once.clear();
        } else if (AT_MOST_ONCE.contains(element) && path.size() > 1 && path.get(path.size() - 2).equals("scene") && !once.add(element)) {
            problems.add(line, column, "a scene has at most one <" + element + ">, but here is another");
        }
    }

    private void setLimits(Attributes given) {
        if (path.size() > SceneFormat.DEEPEST) {
            problems.add(line, column, "elements must not be nested deeper than " + SceneFormat.DEEPEST);
            throw new Problems.Stop();
        }
        for (int i = 0; i < given.getLength(); i++) {
            if (given.getValue(i).length() > LONGEST_VALUE) {
                problems.add(line, column, "the value of " + given.getQName(i) + " must not be longer than " + LONGEST_VALUE
                        + " characters, but has " + given.getValue(i).length(), given.getQName(i));
                throw new Problems.Stop();
            }
        }
    }

    @Override
    public void endElement(String uri, String localName, String qName) throws SAXException {
        // What is found out only now, as that something is missing inside, is told of the start.
        line = lines[path.size()];
        column = columns[path.size()];
        next.endElement(uri, localName, qName);
        isTextTold = false;
        textLength = 0;
        path.remove(path.size() - 1);
        isOver = path.isEmpty();
        advance();
    }

    @Override
    public void characters(char[] text, int start, int length) throws SAXException {
        complainOfText(text, start, start + length);
        if (isText()) {
            next.characters(text, start, length);
        }
        if (isText() || isTextTold) {
            textLength += length;
        }
        if (textLength > LONGEST_TEXT) {
            if (isText()) {
                problems.add(lines[path.size()], columns[path.size()], "a description must not be longer than " + SceneFormat.LONGEST_DESCRIPTION
                        + " characters, but this has more than " + LONGEST_TEXT);
            }
            throw new Problems.Stop();
        }
        advance();
        // The parser has already taken the < that ends the text.
        nextColumn = Math.max(1, nextColumn - 1);
    }

    /** Whether the element at hand holds text. What stands between the elements of others is not handed on: the binding would keep all of it. */
    private boolean isText() {
        return path.get(path.size() - 1).equals("description");
    }

    /** Told here and not by the validator, which would tell the place of the end of the element. */
    private void complainOfText(char[] text, int start, int end) {
        int at = start;
        line = nextLine;
        column = nextColumn;
        while (at < end && text[at] <= ' ') {
            line += text[at] == '\n' ? 1 : 0;
            column = text[at] == '\n' ? 1 : column + 1;
            at++;
        }
        if (at < end && !isTextTold && !isText()) {
            isTextTold = true;
            complaints().addText(path, String.valueOf(text, at, Math.min(end - at, 60)).strip(), line, column);
        }
    }

    @Override
    public void ignorableWhitespace(char[] text, int start, int length) throws SAXException {
        characters(text, start, length);
    }

    @Override
    public void endCDATA() {
        advance();
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
        found.run();
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
        boolean isToldInside = problems.size() > problemsBefore[path.size()];
        complaints().add(String.valueOf(e.getMessage()), path, attributes, isToldInside, line, column);
    }

    private Complaints complaints() {
        if (complaints == null) {
            complaints = new Complaints(problems);
        }
        return complaints;
    }

    /**
     * The file is no XML, or not in the form we take.
     *
     * @throws Problems.Stop always
     */
    void malformed(String message, int atLine, int atColumn) {
        String sentence = Malformed.sentence(message, path.isEmpty() ? "" : path.get(path.size() - 1));
        String sample = "<scene xmlns=\"" + SceneFormat.NAMESPACE + "\">";
        if (message.contains("DOCTYPE")) {
            sentence = "a DOCTYPE is not allowed in a scene file; remove it";
        } else if (prolog.isEmpty()) {
            sentence = "this file is empty; a scene file starts with " + sample;
        } else if (prolog.isBinary()) {
            sentence = "this is a binary file, not a scene file";
        } else if (path.isEmpty() && prolog.isMisdeclared()) {
            sentence = prolog.wrongEncoding();
        } else if (path.isEmpty() && !isOver && message.startsWith("Content is not allowed in prolog")) {
            sentence = "this is not a scene file: it should start with " + sample;
        } else if (path.isEmpty() && !isOver && message.startsWith("XML document structures")) {
            sentence = "the file ends before its first element; is it cut off?";
        } else if (path.isEmpty() && !isOver && message.startsWith("Premature end of file")) {
            sentence = "the file ends before its first element; a scene file starts with " + sample;
        }
        problems.add(Math.max(1, atLine), Math.max(1, atColumn), sentence);
        throw new Problems.Stop();
    }

    /**
     * What comes after all that was found has no end.
     *
     * @throws Problems.Stop always
     */
    void endless(String sentence) {
        problems.add(Math.max(1, nextLine), Math.max(1, nextColumn), "from here on, " + sentence + ", which is beyond all measure");
        throw new Problems.Stop();
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
