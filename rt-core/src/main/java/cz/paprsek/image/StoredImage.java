package cz.paprsek.image;

import cz.paprsek.math.Require;
import java.util.Objects;

/**
 * A picture as it was read from a file.
 *
 * @param image in linear light; grey pictures have three equal channels
 * @param precision how finely the file tells light
 * @param isGrey whether the file holds brightness only
 * @param power that turned its whole numbers, as shares of the largest, into light: 1 if they tell light itself; {@link #SRGB} if they are sRGB-encoded
 */
public record StoredImage(Image image, Precision precision, boolean isGrey, double power) {
    /** No power: the curve of sRGB. */
    public static final double SRGB = 0;

    public StoredImage {
        Objects.requireNonNull(image, "image");
        Objects.requireNonNull(precision, "precision");
        Require.notNegative("power", power);
    }

    /** One whose whole numbers, if it has any, are sRGB-encoded. */
    public StoredImage(Image image, Precision precision, boolean isGrey) {
        this(image, precision, isGrey, SRGB);
    }

    /** How finely a file tells light. */
    public enum Precision {
        /** 256 steps or fewer from 0 to 1. */
        EIGHT_BIT,
        /** Eight bits, with an exponent that the channels of a pixel share. */
        SHARED_EXPONENT,
        /** Floating-point numbers of eleven bits, not clamped. */
        HALF,
        /** 65536 steps from 0 to 1. */
        SIXTEEN_BIT,
        /** Floating-point numbers or decimals, not clamped. */
        FLOAT
    }

    /** A picture that was never in a file. */
    public static StoredImage of(Image image) {
        return new StoredImage(image, Precision.FLOAT, false);
    }
}
