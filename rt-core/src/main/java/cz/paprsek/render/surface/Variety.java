package cz.paprsek.render.surface;

import cz.paprsek.material.Material;
import cz.paprsek.material.Share;
import cz.paprsek.material.Share.ByPattern;
import cz.paprsek.material.Share.ColorChannel;
import cz.paprsek.math.Affine;
import cz.paprsek.render.texture.Textures;
import java.util.List;
import java.util.Optional;

/**
 * What of a material differs from point to point, beside the colour.
 *
 * @param hasShares whether any share does
 */
record Variety(Painted diffusion, Painted specular, Painted reflection, Painted transparency, Painted roughness, boolean hasShares, Bending bending) {
    private static final Painted EVEN = new Painted(ColorChannel.LUMINANCE, Optional.empty());
    /** Nothing. */
    static final Variety NONE = new Variety(EVEN, EVEN, EVEN, EVEN, EVEN, false, Bending.NONE);

    /** How a share depends on the point; not at all without a paint. */
    record Painted(ColorChannel channel, Optional<Paint> paint) {
        /** At the level's hit, whose colour is changed. */
        double share(Level level, double even) {
            if (paint.isEmpty()) {
                return even;
            }
            paint.get().ask(level);
            // A picture may be brighter than white.
            return Math.max(0, Math.min(1, channel.of(level.colorRed, level.colorGreen, level.colorBlue)));
        }

        void tell(Level level, String name, Share share, List<Told> told) {
            if (share instanceof ByPattern by) {
                paint.ifPresent(its -> {
                    its.ask(level);
                    told.add(its.tell(level, name, by.pattern().kind()));
                });
            }
        }

        boolean isByPattern() {
            return paint.isPresent();
        }
    }

    /** Says what each goes by at the level's hit. */
    void tell(Level level, Material.Shares patterns, List<Told> told) {
        diffusion.tell(level, "diffusion", patterns.diffusion(), told);
        specular.tell(level, "specular", patterns.specular(), told);
        reflection.tell(level, "reflection", patterns.reflection(), told);
        transparency.tell(level, "transparency", patterns.transparency(), told);
        roughness.tell(level, "roughness", patterns.roughness(), told);
        bending.tell(level, told);
    }

    boolean isNone() {
        return !hasShares && bending == Bending.NONE;
    }

    static Variety of(Material material, Affine toDeclared, Textures textures) {
        Material.Shares shares = material.shares();
        boolean hasShares = !shares.isEven() && shares.all().anyMatch(ByPattern.class::isInstance);
        return !hasShares && material.relief() instanceof Material.Flat ? NONE : new Variety(
                share(shares.diffusion(), toDeclared, textures), share(shares.specular(), toDeclared, textures), share(shares.reflection(), toDeclared, textures),
                share(shares.transparency(), toDeclared, textures), share(shares.roughness(), toDeclared, textures), hasShares,
                Bending.of(material.relief(), toDeclared, textures));
    }

    private static Painted share(Share share, Affine toDeclared, Textures textures) {
        return share instanceof ByPattern by ? new Painted(by.channel(), Optional.of(Paint.of(by.pattern(), toDeclared, textures, false))) : EVEN;
    }
}
