/** What animations of a scene reckon with: turns between turns, and records with other numbers. */
package cz.paprsek.scene.motion;
