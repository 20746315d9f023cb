package cz.paprsek.teach;

/** An object of the scene, in the world. */
final class Body {
    final Thing thing;
    /** Whether it has an inside. */
    final boolean isSolid;
    /** Whether light gets into that. */
    final boolean isGlass;

    Body(Thing thing, boolean isSolid, boolean isGlass) {
        this.thing = thing;
        this.isSolid = isSolid;
        this.isGlass = isGlass;
    }
}
