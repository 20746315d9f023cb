package cz.paprsek.material;

/** No material of its own: a CSG operand takes its parent's, a whole object takes {@link Material#DEFAULT}. */
public enum Inherited implements MaterialSource {
    INHERITED
}
