package cz.paprsek.image;

import java.util.Objects;

/**
 * A picture as it was read from a file.
 *
 * @param image in linear light; grey pictures have three equal channels
 * @param precision how finely the file tells light
 * @param isGrey whether the file holds brightness only
 */
public record StoredImage(Image image, Precision precision, boolean isGrey) {
    public StoredImage {
        Objects.requireNonNull(image, "image");
        Objects.requireNonNull(precision, "precision");
    }


    /** How finely a file tells light. */
    public enum Precision {
        /** 256 steps or fewer from 0 to 1, sRGB-encoded. */
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
