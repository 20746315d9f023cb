package cz.paprsek.material;

/** Where an object's material comes from: stated on the spot, referred to by name, or taken from above. */
public sealed interface MaterialSource permits Material, MaterialName, Inherited {}
