/** Where bodies touch each other. */
@NullMarked
package cz.paprsek.fx.model.contact;

import org.jspecify.annotations.NullMarked;
