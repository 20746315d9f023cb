package cz.paprsek.ray;

import java.util.Arrays;

/** Scratch of one worker: a line o + t·d in the space of a shape, and where it crosses one that was made in code. */
public final class Line {
    private static final int MOST = 1 << 20;
    private static final double[] NO_PLACES = {};
    private static final int[] NO_FACES = {};

    /** Where it starts, t = 0. */
    public double ox;
    public double oy;
    public double oz;
    /** Its direction, of any length but 0. */
    public double dx;
    public double dy;
    public double dz;
    private double[] places = NO_PLACES;
    private int[] faces = NO_FACES;
    private int crossings;

    /** Notes that it crosses face 0 of a shape at o + t·d; t may be below 0, and infinite for a shape without end. */
    public void cross(double t) {
        cross(t, 0);
    }

    /**
     * Notes that it crosses a face of a shape at o + t·d.
     *
     * @param face by the shape's own numbering, from 0 on
     * @throws IllegalArgumentException if the face is below 0
     * @throws IllegalStateException if there are more than {@value #MOST} crossings: a shape that finds no end
     */
    public void cross(double t, int face) {
        if (face < 0) {
            throw new IllegalArgumentException("the faces of a shape have numbers from 0 on, and one that a line crosses has " + face);
        }
        if (crossings == places.length) {
            if (crossings >= MOST) {
                throw new IllegalStateException("a shape made in code says that a line crosses it more than " + MOST + " times");
            }
            places = Arrays.copyOf(places, Math.max(8, 2 * crossings));
            faces = Arrays.copyOf(faces, places.length);
        }
        places[crossings] = t;
        faces[crossings++] = face;
    }

    /** How many crossings were noted. */
    public int crossings() {
        return crossings;
    }

    /** Where the i-th one is. */
    public double t(int i) {
        return places[i];
    }

    /** Which face is crossed there. */
    public int face(int i) {
        return faces[i];
    }

    /** Forgets all crossings. */
    public void clear() {
        crossings = 0;
    }

    /** Forgets all crossings but the first ones. */
    public void keep(int count) {
        crossings = count;
    }

    /** Puts the crossings into rising order; those in one place keep theirs. */
    public void sort() {
        for (int i = 1; i < crossings; i++) {
            double place = places[i];
            int face = faces[i];
            int at = i;
            for (; at > 0 && places[at - 1] > place; at--) {
                places[at] = places[at - 1];
                faces[at] = faces[at - 1];
            }
            places[at] = place;
            faces[at] = face;
        }
    }
}
