package cz.paprsek.xml.bind;

import cz.paprsek.xml.mistake.Problems;
import org.xml.sax.Attributes;
import org.xml.sax.ContentHandler;
import org.xml.sax.SAXException;
import org.xml.sax.helpers.XMLFilterImpl;

/**
 * Keeps from the binding every element that the schema refuses, with all it holds: a bean never sees a value of the wrong form, and the beans of
 * the others can still be asked what else is wrong.
 */
final class BindingGate extends XMLFilterImpl {
    private final Problems problems;
    /** The problems there were when the last event passed; more now means that the event at hand is what is wrong. */
    private int known;
    /** How many elements are open within the refused one, itself included; 0 outside. */
    private int refused;

    BindingGate(ContentHandler binding, Problems problems) {
        this.problems = problems;
        setContentHandler(binding);
    }

    @Override
    public void startElement(String uri, String localName, String qName, Attributes attributes) throws SAXException {
        if (refused > 0 || problems.size() > known) {
            refused++;
            problems.skip(localName);
        } else {
            super.startElement(uri, localName, qName, attributes);
        }
        known = problems.size();
    }

    @Override
    public void endElement(String uri, String localName, String qName) throws SAXException {
        known = problems.size();
        if (refused > 0) {
            refused--;
        } else {
            super.endElement(uri, localName, qName);
        }
    }

    @Override
    public void characters(char[] text, int start, int length) throws SAXException {
        known = problems.size();
        if (refused == 0) {
            super.characters(text, start, length);
        }
    }
}
