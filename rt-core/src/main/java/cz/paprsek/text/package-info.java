/** Words and numbers as text: the shortest form of a number, what a misspelt word was meant to be. Knows of nothing else here but vectors. */
@NullMarked
package cz.paprsek.text;

import org.jspecify.annotations.NullMarked;
