package cz.paprsek.render.work;

import cz.paprsek.render.integrate.Integrator;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** What a worker keeps from one picture to the next: the scratch it traces with, as long as that fits. */
public final class Desk {
    private @Nullable Object purpose;
    private @Nullable Integrator integrator;

    /**
     * The integrator that was made for an equal purpose, or a new one.
     *
     * @param wanted all that what it does depends on, but for the size of the picture and the eye
     */
    public Integrator integrator(Object wanted, Supplier<? extends Integrator> maker) {
        Integrator kept = integrator;
        if (kept != null && wanted.equals(purpose)) {
            return kept;
        }
        Integrator made = maker.get();
        integrator = made;
        purpose = wanted;
        return made;
    }

    /** Keeps nothing: what failed half-way is not to be used again. */
    public void clear() {
        integrator = null;
    }
}
