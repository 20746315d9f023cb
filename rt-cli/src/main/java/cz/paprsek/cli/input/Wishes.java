package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.Size;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Tile;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import java.util.Optional;

/** What the user wants otherwise than the scenes say. */
public record Wishes(
        Optional<Size> size, Optional<Integer> maxDepth, RayWishes rays, LightWishes light, Optional<Tile> region, Optional<Integer> threads) {

    /** @throws WrongUsage if a number is out of range, or the region outside a picture of the size wished for */
    public Wishes {
        try {
            RenderOptions.of(checked(size, maxDepth, rays, light)).withThreads(threads.orElse(1));
            if (size.isPresent() && region.isPresent()) {
                RenderOptions.of(RenderSettings.DEFAULT.withSize(size.get().width(), size.get().height())).withRegion(region.get());
            }
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(String.valueOf(refused.getMessage()));
        }
    }

    /** @throws IllegalArgumentException if the region does not lie inside the picture */
    public RenderOptions applyTo(RenderSettings settings) {
        RenderOptions options = RenderOptions.of(settings(settings, size, maxDepth, rays, light));
        options = rays.isFixed() ? options.withFixedSampler() : options;
        options = threads.isPresent() ? options.withThreads(threads.get()) : options;
        return region.isPresent() ? options.withRegion(region.get()) : options;
    }

    /** What is asked of a scene must suit one of some kind: which kind it is, is not known yet. */
    private static RenderSettings checked(Optional<Size> size, Optional<Integer> maxDepth, RayWishes rays, LightWishes light) {
        try {
            return settings(RenderSettings.DEFAULT, size, maxDepth, rays, light);
        } catch (IllegalArgumentException | WrongUsage refused) {
            try {
                return settings(RenderSettings.DEFAULT.withIntegrator(Integrator.PATH), size, maxDepth, rays, light);
            } catch (IllegalArgumentException | WrongUsage likewise) {
                throw refused;
            }
        }
    }

    private static RenderSettings settings(
            RenderSettings settings, Optional<Size> size, Optional<Integer> maxDepth, RayWishes rays, LightWishes light) {
        RenderSettings sized = size.map(s -> settings.withSize(s.width(), s.height())).orElse(settings);
        return light.applyTo(rays.applyTo(sized.withMaxDepth(maxDepth.orElse(sized.maxDepth()))));
    }
}
