/** glTF 2.0, as text with files beside it or in one piece (GLB): metres with y up. */
package cz.paprsek.format.gltf;
