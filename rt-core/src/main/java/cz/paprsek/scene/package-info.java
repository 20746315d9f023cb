/**
 * The scene as immutable records: camera, lights, objects, settings. Knows nothing of files, windows or threads.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
@NullMarked
package cz.paprsek.scene;

import org.jspecify.annotations.NullMarked;
