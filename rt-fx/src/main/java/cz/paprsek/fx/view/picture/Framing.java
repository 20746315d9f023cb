package cz.paprsek.fx.view.picture;

import cz.paprsek.render.Tile;
import java.util.Optional;

/**
 * How large a picture is to be rendered.
 *
 * @param columns its width, pixels
 * @param rows its height, pixels
 * @param part the rectangle of it that is rendered alone; empty for all of it
 */
public record Framing(int columns, int rows, Optional<Tile> part) {}
