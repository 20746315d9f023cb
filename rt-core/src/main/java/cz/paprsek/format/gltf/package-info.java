/** glTF 2.0, as text with files beside it or in one piece (GLB): metres with y up. */
@NullMarked
package cz.paprsek.format.gltf;

import org.jspecify.annotations.NullMarked;
