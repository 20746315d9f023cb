package cz.paprsek.format;

import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Bump;
import cz.paprsek.material.Material.NormalMap;
import cz.paprsek.material.Material.Relief;
import cz.paprsek.material.Material.Shares;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Share;
import cz.paprsek.material.Share.ByPattern;
import java.util.function.UnaryOperator;

/** Materials whose pictures go by other names. */
final class Renaming {
    private Renaming() {}

    static Material of(Material material, UnaryOperator<String> name) {
        Shares shares = material.shares();
        return material.withPattern(pattern(material.pattern(), name)).withRelief(relief(material.relief(), name))
                .withShares(new Shares(share(shares.diffusion(), name), share(shares.specular(), name), share(shares.reflection(), name), share(shares.transparency(), name),
                        share(shares.roughness(), name)));
    }

    private static Pattern pattern(Pattern pattern, UnaryOperator<String> name) {
        return pattern instanceof Pattern.Picture one ? new Pattern.Picture(name.apply(one.file()), one.filter(), one.mapping(), one.lay()) : pattern;
    }

    private static Share share(Share share, UnaryOperator<String> name) {
        return share instanceof ByPattern by ? new ByPattern(by.channel(), pattern(by.pattern(), name)) : share;
    }

    private static Relief relief(Relief relief, UnaryOperator<String> name) {
        if (relief instanceof NormalMap map) {
            return new NormalMap(name.apply(map.file()), map.strength(), map.filter(), map.mapping(), map.lay());
        }
        return relief instanceof Bump bump ? new Bump(bump.strength(), pattern(bump.pattern(), name)) : relief;
    }
}
