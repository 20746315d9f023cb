package cz.paprsek.scene;

/** A part of a scene together with the scene: a camera, a light, a named material, the place of an object or operand. */
public record InScene<T>(Scene scene, T part) {}
