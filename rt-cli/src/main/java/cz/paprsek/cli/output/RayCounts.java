package cz.paprsek.cli.output;

import cz.paprsek.io.Json;
import cz.paprsek.render.RenderResult;

/** Rays by kind, as scripts read them. */
public final class RayCounts {
    private RayCounts() {}

    public static Json asJson(RenderResult.Stats stats) {
        return new Json()
                .with("primary", stats.primary())
                .with("reflected", stats.reflected())
                .with("refracted", stats.refracted())
                .with("shadow", stats.shadow())
                .with("total", stats.rays());
    }
}
