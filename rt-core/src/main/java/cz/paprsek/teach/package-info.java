/**
 * A ray tracer to be read aloud, and the mistakes that are made in one: short and slow, it allocates as it likes, and shares nothing with the renderer but the
 * records of a scene and the types of mathematics. Without a mistake its pictures are the renderer's, to the last bit.
 */
@NullMarked
package cz.paprsek.teach;

import org.jspecify.annotations.NullMarked;
