package cz.paprsek.cli.value;

import cz.paprsek.scene.RenderSettings.Integrator;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;

/** How light may be gathered, by the names a user gives; lists them for the help and for shells that complete words. */
public final class Integrators implements Iterable<String> {
    private static final List<String> NAMES = Arrays.stream(Integrator.values()).map(Integrator::toString).toList();

    public static Integrator parse(String name) {
        return Integrator.of(name).orElseThrow(() -> Words.unknown(name, NAMES));
    }

    @Override
    public Iterator<String> iterator() {
        return NAMES.iterator();
    }
}
