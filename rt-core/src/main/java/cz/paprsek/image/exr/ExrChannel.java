package cz.paprsek.image.exr;

/**
 * A channel of a picture.
 *
 * @param name as R, or with its layer before a dot: normal.X
 */
public record ExrChannel(String name, ExrType type) {}
