package cz.paprsek.attribute;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Says that a record's component is an attribute of an element in scene files, of the component's name with hyphens ({@code refractive-index}).
 * Who adds such a component has it in the schema, in files that are read and written, in tables and filters, in summaries and in the property sheet.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Attribute {
    /** Stands in {@link #otherwise()} of what may be missing and then has no value: an empty text, list or optional. */
    String NOTHING = "nothing";

    /** What values it may have. */
    Kind value();

    /** What it means: a sentence for the schema, without what it is if not given. */
    String means();

    /** The value if a file gives none, as a file would have it, or {@link #NOTHING}; empty if a file must give one. */
    String otherwise() default "";

    /** The value, as a file would have it, in an example about 1 across; empty if that is {@link #otherwise()}, or 0.5 if that must be given. */
    String example() default "";

    /** Its name, if that is not the component's. Two components in a row that have one name are one attribute of two numbers. */
    String name() default "";

    /** Whether it stands in an element of its own, and not among the attributes of its record's: a colour as its {@code color}, a text as what is inside. */
    boolean isElement() default false;

    /**
     * The method of the element's record that says what counts, where the component may hold what stands for nothing given, or does not matter: what
     * stands in for it, an empty optional or an infinite number for nothing, or whether the value itself counts. Empty if it always does.
     */
    String inForce() default "";
}
