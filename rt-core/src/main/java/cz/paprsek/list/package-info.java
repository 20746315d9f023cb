/** Immutable lists that share what is the same, and what two of them differ in. */
@NullMarked
package cz.paprsek.list;

import org.jspecify.annotations.NullMarked;
