package cz.paprsek.tree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Subtrees to start from are kept from near to far, whichever come and go. */
class EntriesTest {
    private static final int WIDTH = 8;
    private static final int STRIDE = WideNodes.EACH * WIDTH;

    private record Entry(int node, int box, double near) {}

    @Test
    void subtreesAreKeptInTheOrderOfTheirDistance() {
        Random random = new Random(5);
        for (int round = 0; round < 300; round++) {
            Entries entries = new Entries(12);
            List<Entry> kept = new ArrayList<>();
            for (int i = 0; i < 60; i++) {
                if (!kept.isEmpty() && (entries.isFull() || random.nextInt(3) == 0)) {
                    int at = random.nextInt(kept.size());
                    entries.remove(at);
                    kept.remove(at);
                } else {
                    // Four kinds: a leaf anywhere, a leaf in a box, a node in a box, and the root, which is a node anywhere.
                    int kind = random.nextInt(4);
                    Entry entry = new Entry(kind == 3 ? 0 : kind == 2 ? 1 + i : -1 - i, kind % 3 == 0 ? Entries.ANYWHERE : 8 * i, random.nextDouble());
                    entries.add(entry.node, entry.box, entry.near);
                    kept.add(entry);
                    kept.sort(Comparator.comparingDouble(Entry::near));
                }
                assertHolds(entries, kept);
                Entries copy = new Entries(12);
                copy.add(7, 8, 0.5);
                copy.startWith(entries);
                assertHolds(copy, kept);
            }
        }
    }

    @Test
    void oneMoreHasRoomThanAreKeptApart() {
        Entries entries = new Entries(8);
        for (int i = 0; i < 7; i++) {
            assertThat(entries.haveRoomFor(2)).isTrue();
            assertThat(entries.haveRoomFor(9 - i)).isTrue();
            // Of more than eight no more count.
            assertThat(entries.haveRoomFor(10 - i)).isEqualTo(i < 2);
            assertThat(entries.haveRoomFor(16)).isEqualTo(i < 2);
            entries.add(1, 8, i);
        }
        assertThat(entries.isFull()).isFalse();
        entries.add(1, 8, 8);
        assertThat(entries.isFull()).isTrue();
    }

    /** The wide tree's way: the boxes of eight side by side, and empty ones that no line meets. */
    @Test
    void boxesAreGatheredInGroupsOfEight() {
        float[] planes = new float[STRIDE * 4];
        for (int i = 0; i < planes.length; i++) {
            planes[i] = i;
        }
        Entries entries = new Entries(16);
        for (int i = 0; i < 11; i++) {
            entries.add(i == 4 ? -9 : 100 + i, i == 4 ? Entries.ANYWHERE : i % WIDTH + STRIDE * (i / WIDTH), i);
        }
        entries.gather(planes, WIDTH);
        assertThat(entries.groups).isEqualTo(2);
        assertThat(entries.groupNear[0]).isZero();
        assertThat(entries.groupNear[1]).as("the ninth box, behind one that is anywhere").isEqualTo(9);
        int slot = 0;
        for (int i = 0; i < 11; i++) {
            if (i != 4) {
                int at = WideNodes.FIRST + STRIDE * (slot / WIDTH) + slot % WIDTH;
                assertThat(Float.floatToRawIntBits(entries.planes[at + WIDTH * 6])).isEqualTo(100 + i);
                for (int k = 0; k < 6; k++) {
                    assertThat(entries.planes[at + WIDTH * k])
                            .isEqualTo(i % WIDTH + STRIDE * (i / WIDTH) + WIDTH * k);
                }
                slot++;
            }
        }
        for (; slot < 2 * WIDTH; slot++) {
            int at = WideNodes.FIRST + STRIDE * (slot / WIDTH) + slot % WIDTH;
            for (int k = 0; k < 6; k++) {
                assertThat(entries.planes[at + WIDTH * k]).isNaN();
            }
        }
    }

    private static void assertHolds(Entries entries, List<Entry> kept) {
        assertThat(entries.size).isEqualTo(kept.size());
        assertThat(entries.isEmpty()).isEqualTo(kept.isEmpty());
        assertThat(entries.haveBoxes()).isEqualTo(kept.stream().anyMatch(e -> e.box != Entries.ANYWHERE || e.node >= 0));
        for (int i = 0; i < kept.size(); i++) {
            Entry entry = kept.get(i);
            assertThat(new Entry(entries.node[i], entries.box[i], entries.near[i])).isEqualTo(entry);
            assertThat(entries.isLeafAnywhere(i)).isEqualTo(entry.box == Entries.ANYWHERE && entry.node < 0);
        }
    }
}
