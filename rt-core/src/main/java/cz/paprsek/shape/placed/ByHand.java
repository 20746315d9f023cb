package cz.paprsek.shape.placed;

import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;

/** What a shape that was made in code is asked, in its own space: as {@code cz.paprsek.shape.CustomShape} says. */
public interface ByHand {
    String kind();

    Bounds bounds();

    double cost();

    void cross(Line line);

    void normal(int face, Hit hit);

    void map(int face, Hit hit);
}
