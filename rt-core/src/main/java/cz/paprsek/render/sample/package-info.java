/** Where a pixel's rays go through, and the random numbers of lens, time and lights. */
@NullMarked
package cz.paprsek.render.sample;

import org.jspecify.annotations.NullMarked;
