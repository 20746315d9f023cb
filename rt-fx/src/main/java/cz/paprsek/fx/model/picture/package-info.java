/** Pictures under way that outlive the program: what is done of them, and what they are pictures of. Knows no window. */
@NullMarked
package cz.paprsek.fx.model.picture;

import org.jspecify.annotations.NullMarked;
