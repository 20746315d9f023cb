/**
 * What a scene needs beside its own file: pictures, and what else it names. Only what lies in the folder of the scene, or is handed in, can be read; and
 * once only, so that all parts of a picture see the same.
 */
@NullMarked
package cz.paprsek.asset;

import org.jspecify.annotations.NullMarked;
