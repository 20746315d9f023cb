/**
 * What shapes, patterns and lights are asked with: lines, and the places where they meet surfaces. Scratch of one worker each, so that nothing
 * is allocated for a ray.
 */
package cz.paprsek.ray;
