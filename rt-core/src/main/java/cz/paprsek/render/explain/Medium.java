package cz.paprsek.render.explain;

/**
 * What a ray travels through.
 *
 * @param name of the solid entered last; empty outside of all
 * @param refractiveIndex relative to the vacuum
 */
public record Medium(String name, double refractiveIndex) {}
