/** What animations of a scene reckon with: turns between turns, and records with other numbers. */
@NullMarked
package cz.paprsek.scene.motion;

import org.jspecify.annotations.NullMarked;
