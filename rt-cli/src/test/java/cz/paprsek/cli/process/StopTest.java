package cz.paprsek.cli.process;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class StopTest {
    @Test
    void nothingIsWrittenAfterARequest() {
        Stop stop = new Stop();
        stop.request();
        AtomicBoolean written = new AtomicBoolean();
        assertThatThrownBy(() -> stop.guard(() -> written.set(true))).isInstanceOf(InterruptedIOException.class);
        assertThat(written).isFalse();
    }

    @Test
    @Timeout(10)
    void aWriteUnderWayIsInterruptedAndWaitedFor() throws Exception {
        Stop stop = new Stop();
        CountDownLatch begun = new CountDownLatch(1);
        AtomicBoolean cleaned = new AtomicBoolean();
        AtomicBoolean stillInterrupted = new AtomicBoolean(true);
        Thread writer = new Thread(() -> {
            try {
                stop.guard(() -> {
                    begun.countDown();
                    try {
                        Thread.sleep(60_000);
                    } catch (InterruptedException e) {
                        cleaned.set(true);
                    }
                });
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
            stillInterrupted.set(Thread.currentThread().isInterrupted());
            stop.ended();
        });
        writer.start();
        begun.await();
        stop.requestAndWait();
        assertThat(cleaned).isTrue();
        writer.join();
        assertThat(stillInterrupted).isFalse();
    }

    @Test
    @Timeout(10)
    void aCommandThatIsOverIsNotWaitedFor() {
        Stop stop = new Stop();
        stop.ended();
        stop.requestAndWait();
        assertThat(stop.requested()).isTrue();
    }
}
