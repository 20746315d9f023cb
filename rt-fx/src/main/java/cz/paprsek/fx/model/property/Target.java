package cz.paprsek.fx.model.property;

import cz.paprsek.scene.Scene;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

/** Records of one kind within a scene that are shown and changed together. */
public interface Target {

    /** The records as they are in a scene; none if they are gone. */
    List<? extends Record> read(Scene scene);

    /** Where in a file the record stands, if it is one; empty for several. */
    Optional<Spot> spot(Scene scene);

    /**
     * The scene with each of the records changed.
     *
     * @throws IllegalArgumentException with what is wrong, if a record or the scene refuses the change
     */
    Scene change(Scene scene, UnaryOperator<Record> change);
}
