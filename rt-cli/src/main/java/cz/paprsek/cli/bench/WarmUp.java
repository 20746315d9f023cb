package cz.paprsek.cli.bench;

import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.util.Optional;
import java.util.function.LongSupplier;

/** How long a scene is rendered before a render counts: until the compiler of the virtual machine has little to do, which takes longer on a busy machine. */
final class WarmUp {
    private static final int LEAST = 4;
    private static final int MOST = 20;
    /** After so many renders in a row beside which little was compiled, and so many nanoseconds of them: what takes longer than one is told only when it is done. */
    private static final int CALM = 3;
    private static final long CALM_NANOS = 500_000_000;
    /** How much of a render's time is little. */
    private static final double LITTLE = 0.02;

    private final LongSupplier compiling;
    private final LongSupplier clock;
    private int renders;
    private int calm;
    private long calmNanos;
    private long compiled;
    private long now;

    /** Of this virtual machine; where nothing is compiled any more, as in a program that was compiled before, it ends early. */
    WarmUp() {
        this(Optional.ofNullable(ManagementFactory.getCompilationMXBean()).filter(CompilationMXBean::isCompilationTimeMonitoringSupported)
                .<LongSupplier>map(compiler -> compiler::getTotalCompilationTime).orElse(() -> 0), System::nanoTime);
    }

    /**
     * With clocks of its own.
     *
     * @param compiling for how long the compiler has been at work, milliseconds
     * @param clock what time it is, nanoseconds
     */
    WarmUp(LongSupplier compiling, LongSupplier clock) {
        this.compiling = compiling;
        this.clock = clock;
        compiled = compiling.getAsLong();
        now = clock.getAsLong();
    }

    /** To be asked after each render: whether another one is needed before those that count. */
    boolean goesOn() {
        long before = now;
        long compiledBefore = compiled;
        now = clock.getAsLong();
        compiled = compiling.getAsLong();
        boolean isCalm = (compiled - compiledBefore) * 1e6 <= LITTLE * (now - before);
        calm = isCalm ? calm + 1 : 0;
        calmNanos = isCalm ? calmNanos + now - before : 0;
        renders++;
        return renders < LEAST || ((calm < CALM || calmNanos < CALM_NANOS) && renders < MOST);
    }
}
