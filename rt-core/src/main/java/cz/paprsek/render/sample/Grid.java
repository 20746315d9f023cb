package cz.paprsek.render.sample;

import cz.paprsek.scene.RenderSettings;

/** A regular grid, row by row, the same in every pixel: with the box filter, a picture of n × n samples is the average of a picture n times the size. */
final class Grid extends Sampling {
    private final Place[] places;

    Grid(RenderSettings settings, boolean fixed) {
        super(settings, settings.mostRays(), fixed);
        int perSide = settings.samples();
        places = new Place[perSide * perSide];
        for (int i = 0; i < places.length; i++) {
            int row = i / perSide;
            int column = i % perSide;
            places[i] = new Place();
            place((column + 0.5) / perSide, (row + 0.5) / perSide, places[i]);
        }
    }

    @Override
    public boolean isPlain() {
        return places.length == 1;
    }

    @Override
    public int rays() {
        return places.length;
    }

    @Override
    public int further(PixelSums own) {
        return 0;
    }

    @Override
    public void place(Sampler sampler, int x, int y, int sample, Place out) {
        Place place = places[sample];
        out.x = place.x;
        out.y = place.y;
        out.isNegative = place.isNegative;
    }
}
