package cz.paprsek.xml;

import org.xml.sax.Attributes;
import org.xml.sax.ContentHandler;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.helpers.DefaultHandler;

/** Lets elements through to the binding as long as nothing is wrong: a bean never sees a value that the schema refuses. */
final class BindingGate extends DefaultHandler {
    private final ContentHandler binding;
    private final Problems problems;

    BindingGate(ContentHandler binding, Problems problems) {
        this.binding = binding;
        this.problems = problems;
    }

    private boolean isOpen() {
        return problems.size() == 0;
    }

    @Override
    public void setDocumentLocator(Locator locator) {
        binding.setDocumentLocator(locator);
    }

    @Override
    public void startDocument() throws SAXException {
        binding.startDocument();
    }

    @Override
    public void endDocument() throws SAXException {
        if (isOpen()) {
            binding.endDocument();
        }
    }

    @Override
    public void startPrefixMapping(String prefix, String uri) throws SAXException {
        if (isOpen()) {
            binding.startPrefixMapping(prefix, uri);
        }
    }

    @Override
    public void endPrefixMapping(String prefix) throws SAXException {
        if (isOpen()) {
            binding.endPrefixMapping(prefix);
        }
    }

    @Override
    public void startElement(String uri, String localName, String qName, Attributes attributes) throws SAXException {
        if (isOpen()) {
            binding.startElement(uri, localName, qName, attributes);
        }
    }

    @Override
    public void endElement(String uri, String localName, String qName) throws SAXException {
        if (isOpen()) {
            binding.endElement(uri, localName, qName);
        }
    }

    @Override
    public void characters(char[] text, int start, int length) throws SAXException {
        if (isOpen()) {
            binding.characters(text, start, length);
        }
    }
}
