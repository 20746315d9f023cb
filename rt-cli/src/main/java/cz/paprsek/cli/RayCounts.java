package cz.paprsek.cli;

import cz.paprsek.io.Json;
import cz.paprsek.render.RenderStats;

/** Rays by kind, as scripts read them. */
final class RayCounts {
    private RayCounts() {}

    static Json asJson(RenderStats stats) {
        return new Json()
                .with("primary", stats.primary())
                .with("reflected", stats.reflected())
                .with("refracted", stats.refracted())
                .with("shadow", stats.shadow())
                .with("total", stats.rays());
    }
}
