package cz.paprsek.fx.model.edit;

import cz.paprsek.material.Material;

/** Materials to start from; each has a text with the key "ready." and its name in lower case. */
public enum ReadyMaterial {
    GLASS, WATER, DIAMOND, MIRROR, STEEL, GOLD, PLASTIC, RUBBER;

    public Material material() {
        return switch (this) {
            case GLASS -> Material.color(240, 246, 255).withDiffusion(0.03).withHighlight(0.9, 200).withTransparency(0.9, 1.5);
            case WATER -> Material.color(225, 242, 250).withDiffusion(0.02).withHighlight(0.7, 150).withTransparency(0.92, 1.33);
            case DIAMOND -> Material.color(255, 255, 255).withDiffusion(0).withHighlight(1, 500).withReflection(0.1).withTransparency(0.9, 2.42);
            case MIRROR -> Material.color(230, 232, 236).withDiffusion(0.03).withHighlight(0.8, 300).withReflection(0.92);
            case STEEL -> Material.color(180, 190, 200).withDiffusion(0.3).withHighlight(0.6, 100).withReflection(0.5);
            case GOLD -> Material.color(255, 196, 70).withDiffusion(0.6).withHighlight(0.5, 60).withReflection(0.25);
            case PLASTIC -> Material.color(210, 60, 50).withDiffusion(0.8).withHighlight(0.4, 40);
            case RUBBER -> Material.color(70, 70, 74).withDiffusion(0.85).withHighlight(0.05, 8);
        };
    }
}
