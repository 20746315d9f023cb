package cz.paprsek.attribute;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** Says that a record is an element in scene files, and what that is, in a sentence for the schema. */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
public @interface Element {
    /** The sentence. */
    String value();

    /** Its name, if that is not the record's with hyphens ({@code point-light}). */
    String name() default "";
}
