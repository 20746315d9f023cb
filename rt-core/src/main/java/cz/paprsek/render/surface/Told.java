package cz.paprsek.render.surface;

/**
 * What a pattern has at a hit.
 *
 * @param of what goes by it: {@code color}, the name of a share, {@code bump} or {@code normal-map}
 * @param pattern its kind
 * @param file of a picture; empty if it is none
 * @param u where in the picture; without meaning if it is none, as are the next five
 * @param column of its nearest point
 * @param row of that, from the top
 * @param pointRed what the picture has there
 * @param red what was found: linear light of a color, else numbers
 */
public record Told(String of, String pattern, String file, double u, double v, int column, int row,
        double pointRed, double pointGreen, double pointBlue, double red, double green, double blue) {}
