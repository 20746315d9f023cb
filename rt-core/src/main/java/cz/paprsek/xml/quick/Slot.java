package cz.paprsek.xml.quick;

import cz.paprsek.attribute.Described;
import java.nio.charset.StandardCharsets;

/**
 * An attribute of a start tag.
 *
 * @param otherwise the value if it is not given
 */
record Slot(Name name, ValueForm form, boolean isRequired, Object otherwise) {
    /** Stands for a value that is not given; no text that is given is empty. */
    static final Object NONE = "";

    static Slot required(String name, ValueForm form) {
        return new Slot(new Name(name), form, true, NONE);
    }

    static Slot optional(String name, ValueForm form, Object otherwise) {
        return new Slot(new Name(name), form, false, otherwise);
    }

    /** The same, with no value if it is not given. */
    Slot unlessGiven() {
        return new Slot(name, form, false, NONE);
    }

    /** The attribute of a record's component. */
    static Slot of(Described one) {
        ValueForm form = ValueForm.of(one);
        return one.isRequired() ? required(one.name(), form) : optional(one.name(), form, ValueForm.standard(one));
    }

    static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }
}
