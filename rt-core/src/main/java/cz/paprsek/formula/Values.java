package cz.paprsek.formula;

import java.util.Collection;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;

/** What the names in a formula stand for. */
public interface Values {
    /** No names but {@code pi}. */
    Values NONE = of(Map.of());

    /**
     * The value of a name; empty if there is none of it.
     *
     * @throws IllegalArgumentException with a sentence that says why it has no value
     */
    OptionalDouble of(String name);

    /** All names there are, for who misspelt one. */
    Collection<String> names();

    static Values of(Map<String, Double> values) {
        Map<String, Double> all = Map.copyOf(values);
        return new Values() {
            @Override
            public OptionalDouble of(String name) {
                Double value = all.get(name);
                return value == null ? OptionalDouble.empty() : OptionalDouble.of(value);
            }

            @Override
            public Set<String> names() {
                return all.keySet();
            }
        };
    }
}
