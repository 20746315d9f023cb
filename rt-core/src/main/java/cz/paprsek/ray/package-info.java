/**
 * What shapes, patterns and lights are asked with: lines, and the places where they meet surfaces. Scratch of one worker each, so that nothing
 * is allocated for a ray.
 */
@NullMarked
package cz.paprsek.ray;

import org.jspecify.annotations.NullMarked;
