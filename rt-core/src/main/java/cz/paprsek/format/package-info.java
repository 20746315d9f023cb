/** Files of other programs: which they are, and what is in them. One room below for each format; none of them fetches anything or believes a number that a file claims. */
@NullMarked
package cz.paprsek.format;

import org.jspecify.annotations.NullMarked;
