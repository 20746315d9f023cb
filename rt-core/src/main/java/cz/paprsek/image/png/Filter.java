package cz.paprsek.image.png;

/**
 * What is done to a row's bytes so that they compress better: each is written as its difference from a prediction made of the byte before it
 * in the same channel, the one above, and the one before that.
 *
 * <p>Rows lie in arrays behind as many zeros as a pixel has bytes, so that the first pixel has a neighbour too.
 *
 * @source PNG Specification (Third Edition), 9.2 Filter types for filter method 0
 */
enum Filter {
    NONE(0) {
        @Override
        void apply(byte[] row, byte[] above, int pixel, int from, int to, byte[] filtered) {
            System.arraycopy(row, from, filtered, from - pixel, to - from);
        }

        @Override
        void undo(byte[] row, byte[] above, int pixel) {}
    },
    SUB(1) {
        @Override
        void apply(byte[] row, byte[] above, int pixel, int from, int to, byte[] filtered) {
            for (int i = from; i < to; i++) {
                filtered[i - pixel] = (byte) (row[i] - row[i - pixel]);
            }
        }

        @Override
        void undo(byte[] row, byte[] above, int pixel) {
            for (int i = pixel; i < row.length; i++) {
                row[i] += row[i - pixel];
            }
        }
    },
    UP(2) {
        @Override
        void apply(byte[] row, byte[] above, int pixel, int from, int to, byte[] filtered) {
            for (int i = from; i < to; i++) {
                filtered[i - pixel] = (byte) (row[i] - above[i]);
            }
        }

        @Override
        void undo(byte[] row, byte[] above, int pixel) {
            for (int i = pixel; i < row.length; i++) {
                row[i] += above[i];
            }
        }
    },
    AVERAGE(3) {
        @Override
        void apply(byte[] row, byte[] above, int pixel, int from, int to, byte[] filtered) {
            for (int i = from; i < to; i++) {
                filtered[i - pixel] = (byte) (row[i] - (((row[i - pixel] & 0xFF) + (above[i] & 0xFF)) >> 1));
            }
        }

        @Override
        void undo(byte[] row, byte[] above, int pixel) {
            for (int i = pixel; i < row.length; i++) {
                row[i] += (byte) (((row[i - pixel] & 0xFF) + (above[i] & 0xFF)) >> 1);
            }
        }
    },
    PAETH(4) {
        @Override
        void apply(byte[] row, byte[] above, int pixel, int from, int to, byte[] filtered) {
            for (int i = from; i < to; i++) {
                filtered[i - pixel] = (byte) (row[i] - nearest(row[i - pixel] & 0xFF, above[i] & 0xFF, above[i - pixel] & 0xFF));
            }
        }

        @Override
        void undo(byte[] row, byte[] above, int pixel) {
            for (int i = pixel; i < row.length; i++) {
                row[i] += (byte) nearest(row[i - pixel] & 0xFF, above[i] & 0xFF, above[i - pixel] & 0xFF);
            }
        }

        /** That of the three which is nearest to left + above − corner; in this order if several are. */
        private static int nearest(int left, int above, int corner) {
            int toLeft = Math.abs(above - corner);
            int toAbove = Math.abs(left - corner);
            int toCorner = Math.abs(left + above - 2 * corner);
            if (toLeft <= toAbove && toLeft <= toCorner) {
                return left;
            }
            return toAbove <= toCorner ? above : corner;
        }
    };

    private final int number;

    Filter(int number) {
        this.number = number;
    }

    /** What stands for it in a file. */
    int number() {
        return number;
    }

    /**
     * Filters a part of a row.
     *
     * @param above the row above it; zeros above the first
     * @param pixel how many bytes a pixel has
     * @param from the first byte, counted with the zeros before the row
     * @param to the one after the last
     * @param filtered gets the filtered bytes at their places in a row without zeros before it
     */
    abstract void apply(byte[] row, byte[] above, int pixel, int from, int to, byte[] filtered);

    /** Turns filtered bytes back into the row they were. */
    abstract void undo(byte[] row, byte[] above, int pixel);
}
