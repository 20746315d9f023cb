/** OpenEXR files as bytes and named planes of numbers; knows nothing of light. */
package cz.paprsek.image.exr;
