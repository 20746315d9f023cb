package cz.paprsek.cli;

import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderStats;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/** What is said of one finished render. */
record RenderReport(Path scene, Path picture, RenderResult result) {

    String toLine() {
        RenderStats stats = result.stats();
        return String.format(Locale.ROOT, "%s -> %s  %dx%d  %.2f s  %.1f Mray/s", scene, picture, result.image().width(),
                result.image().height(), stats.buildSeconds() + stats.traceSeconds(), stats.rays() / 1e6 / Math.max(1e-9, stats.traceSeconds()));
    }

    String toJson() {
        RenderStats stats = result.stats();
        Map<String, Object> json = new LinkedHashMap<>();
        json.put("scene", scene);
        json.put("file", picture);
        json.put("outcome", result.outcome().name().toLowerCase(Locale.ROOT));
        json.put("width", result.image().width());
        json.put("height", result.image().height());
        json.put("buildSeconds", stats.buildSeconds());
        json.put("traceSeconds", stats.traceSeconds());
        json.put("primaryRays", stats.primary());
        json.put("reflectedRays", stats.reflected());
        json.put("refractedRays", stats.refracted());
        json.put("shadowRays", stats.shadow());
        json.put("hits", stats.hits());
        return Json.of(json);
    }
}
