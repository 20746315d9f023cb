package cz.paprsek.material;

/** What a material is made of while it is being changed. */
final class MaterialParts {
    Pattern pattern;
    double diffusion;
    double specular;
    double shininess;
    double reflection;
    double transparency;
    double refractiveIndex;
    Material.Fresnel fresnel;
    double roughness;
    boolean thin;
    Rgb attenuationColor;
    double attenuationDistance;
    Rgb emission;
    double emissionStrength;
    Material.Shares shares;
    Material.Relief relief;

    MaterialParts(Material of) {
        pattern = of.pattern();
        diffusion = of.diffusion();
        specular = of.specular();
        shininess = of.shininess();
        reflection = of.reflection();
        transparency = of.transparency();
        refractiveIndex = of.refractiveIndex();
        fresnel = of.fresnel();
        roughness = of.roughness();
        thin = of.thin();
        attenuationColor = of.attenuationColor();
        attenuationDistance = of.attenuationDistance();
        emission = of.emission();
        emissionStrength = of.emissionStrength();
        shares = of.shares();
        relief = of.relief();
    }

    Material together() {
        return new Material(pattern, diffusion, specular, shininess, reflection, transparency, refractiveIndex, fresnel,
                roughness, thin, attenuationColor, attenuationDistance, emission, emissionStrength, shares, relief);
    }
}
