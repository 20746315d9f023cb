/** What reading and writing of all kinds of file have in common. Knows nothing of scenes or pictures. */
@NullMarked
package cz.paprsek.io;

import org.jspecify.annotations.NullMarked;
