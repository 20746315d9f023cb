package cz.paprsek.render.explain.text;

import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.text.Step.Topic;

/** How a tree is made to look where there is more than letters. */
public interface Decoration {
    /** Letters only. */
    Decoration NONE = new Decoration() {};

    /** The name of a ray and what it meets. */
    default String headline(TracedRay.Kind kind, String text) {
        return text;
    }

    /** The lines of the tree between rays. */
    default String branch(String text) {
        return text;
    }

    default String name(Topic topic, String text) {
        return text;
    }

    default String formula(String text) {
        return text;
    }

    default String numbers(String text) {
        return text;
    }

    default String result(Topic topic, String text) {
        return text;
    }

    /** A patch in the colour of a light as a picture shows it; may be empty. */
    default String patch(LinearRgb light) {
        return "";
    }
}
