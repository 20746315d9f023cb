/** PNG files as bytes and samples; knows nothing of light. */
package cz.paprsek.image.png;
