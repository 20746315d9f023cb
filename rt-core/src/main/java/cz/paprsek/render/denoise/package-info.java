/** Takes noise out of pictures of paths. */
package cz.paprsek.render.denoise;
