package cz.paprsek.scene;

/** A part of a scene together with the scene: a camera, a light, a named material. */
public record InScene<T>(Scene scene, T part) {}
