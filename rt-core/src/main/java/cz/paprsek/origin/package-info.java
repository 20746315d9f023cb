/** What pictures tell of where they come from. */
@NullMarked
package cz.paprsek.origin;

import org.jspecify.annotations.NullMarked;
