/** Takes noise out of pictures of paths. */
@NullMarked
package cz.paprsek.render.denoise;

import org.jspecify.annotations.NullMarked;
