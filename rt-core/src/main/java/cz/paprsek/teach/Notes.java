package cz.paprsek.teach;

import java.util.LinkedHashMap;
import java.util.Map;

/** Writes down, by the names that formulas have for them, the numbers of one ray from the eye. */
class Notes {
    /** Writes nothing down. */
    static final Notes NONE = new Notes();

    Notes put(String name, double value) {
        return put(name, new double[] {value});
    }

    Notes put(String name, Vec value) {
        return put(name, new double[] {value.x(), value.y(), value.z()});
    }

    /** @param value one number, or three */
    Notes put(String name, double[] value) {
        return this;
    }

    /** On paper; of a name that comes twice the last value counts. */
    static final class Written extends Notes {
        final Map<String, double[]> values = new LinkedHashMap<>();

        @Override
        Notes put(String name, double[] value) {
            values.put(name, value);
            return this;
        }
    }
}
