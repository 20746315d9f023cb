package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.render.surface.Media;
import org.junit.jupiter.api.Test;

class MediaTest {
    private final Media media = new Media();

    @Test
    void outsideOfAllIsVacuum() {
        assertThat(media.refractiveIndex()).isEqualTo(1);
        assertThat(media.innermost()).isEqualTo(-1);
        media.leave(3);
        assertThat(media.innermost()).isEqualTo(-1);
    }

    @Test
    void theSolidEnteredLastCountsHoweverManyThereAre() {
        for (int i = 0; i < 40; i++) {
            media.enter(i, 1 + i / 100.0);
        }
        Media copy = new Media();
        copy.enter(99, 2);
        copy.set(media);
        for (int i = 39; i >= 0; i--) {
            assertThat(copy.innermost()).isEqualTo(i);
            assertThat(copy.refractiveIndex()).isEqualTo(1 + i / 100.0);
            copy.leave(i);
        }
        assertThat(copy.refractiveIndex()).isEqualTo(1);
        assertThat(media.innermost()).as("the original is left alone").isEqualTo(39);
    }

    @Test
    void aSolidMayBeLeftBeforeThoseEnteredAfterIt() {
        media.enter(1, 1.5);
        media.enter(2, 1.3);
        media.leave(1);
        assertThat(media.refractiveIndex()).isEqualTo(1.3);
        media.leave(2);
        assertThat(media.refractiveIndex()).isEqualTo(1);
    }

    @Test
    void aSolidEnteredTwiceIsLeftOnce() {
        media.enter(1, 1.5);
        media.enter(2, 1.3);
        media.enter(1, 1.5);
        assertThat(media.innermost()).isEqualTo(1);
        media.leave(1);
        assertThat(media.innermost()).isEqualTo(2);
        media.leave(2);
        assertThat(media.innermost()).isEqualTo(-1);
    }
}
