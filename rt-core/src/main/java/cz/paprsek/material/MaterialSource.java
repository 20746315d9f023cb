package cz.paprsek.material;

/** Where an object's material comes from: stated on the spot, referred to by name, or taken from above. */
public sealed interface MaterialSource permits Material, MaterialName, MaterialSource.Inherited {
    /** No material of its own: a CSG operand takes its parent's, a whole object takes {@link Material#DEFAULT}. */
    enum Inherited implements MaterialSource {
        INHERITED
    }
}
