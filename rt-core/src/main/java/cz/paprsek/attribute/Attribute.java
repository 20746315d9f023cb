package cz.paprsek.attribute;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Says that a record's component is an attribute of an element in scene files, of the component's name with hyphens ({@code refractive-index}).
 * Who adds such a component has it in the schema, in files that are written, in tables and filters, in summaries and in the property sheet.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Attribute {
    /** What values it may have. */
    Kind value();

    /** What it means: a sentence for the schema, without what it is if not given. */
    String means();

    /** The value if a file gives none, as a file would have it; empty if a file must give one. */
    String otherwise() default "";
}
