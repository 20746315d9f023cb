package cz.paprsek.scene;

import cz.paprsek.math.Vec3;

/** A light that stands somewhere. */
public sealed interface PlacedLight extends Light permits PointLight, SpotLight, AreaLight, SphereLight {
    /** The most shadow rays that a point sends to a light. */
    int MOST_SAMPLES = 4096;

    /** Where its middle is, world space. */
    Vec3 position();

    PlacedLight withPosition(Vec3 value);
}
