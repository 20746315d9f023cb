package cz.paprsek.render.surface;

import static org.assertj.core.api.Assertions.assertThat;

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

    @Test
    void anOpaqueSolidAroundTheRayIsNoMedium() {
        assertThat(media.areAround()).isFalse();
        media.surround(7);
        assertThat(media.hold(7)).isTrue();
        assertThat(media.areAround()).isFalse();
        assertThat(media.count()).isZero();
        assertThat(media.innermost()).isEqualTo(-1);
        assertThat(media.refractiveIndex()).isEqualTo(1);
        media.enter(1, 1.5);
        media.enter(2, 1.3);
        assertThat(media.areAround()).isTrue();
        assertThat(media.count()).isEqualTo(2);
        assertThat(media.object(0)).isEqualTo(1);
        assertThat(media.object(1)).isEqualTo(2);
        media.leave(1);
        media.leave(2);
        assertThat(media.areAround()).isFalse();
        assertThat(media.count()).isZero();
        media.clear();
        assertThat(media.hold(7)).isFalse();
    }

    @Test
    void anOpaqueSolidAroundTheRayMayBeLeft() {
        media.surround(7);
        media.surround(8);
        media.enter(1, 1.5);
        media.leave(7);
        assertThat(media.hold(7)).isFalse();
        assertThat(media.hold(8)).isTrue();
        assertThat(media.count()).isEqualTo(1);
        assertThat(media.innermost()).isEqualTo(1);
        media.leave(8);
        media.leave(1);
        assertThat(media.innermost()).isEqualTo(-1);
        assertThat(media.refractiveIndex()).isEqualTo(1);
    }

    @Test
    void whoFollowsARayOutsideOfAllIsOutsideOfAll() {
        media.surround(7);
        media.enter(1, 1.5);
        media.pass(2);
        media.set(new Media());
        assertThat(media.hold(7)).isFalse();
        assertThat(media.havePassed(2)).isFalse();
        assertThat(media.count()).isZero();
        media.enter(3, 1.3);
        assertThat(media.areAround()).isTrue();
        assertThat(media.refractiveIndex()).isEqualTo(1.3);
    }

    @Test
    void whatWasPassedHereIsKnownUntilTheRayGoesOn() {
        for (int i = 0; i < 9; i++) {
            assertThat(media.havePassed(i)).isFalse();
            media.pass(i);
            assertThat(media.havePassed(i)).isTrue();
        }
        Media copy = new Media();
        copy.pass(20);
        copy.set(media);
        for (int i = 0; i < 9; i++) {
            assertThat(copy.havePassed(i)).isTrue();
        }
        assertThat(copy.havePassed(20)).isFalse();
        media.forgetPassed();
        assertThat(media.havePassed(0)).isFalse();
        assertThat(copy.havePassed(0)).as("the copy is its own").isTrue();
        copy.clear();
        assertThat(copy.havePassed(0)).isFalse();
    }
}
