/** Lights and sky as they are seen: what eyes and paths meet of them, and how a sky is looked for. */
package cz.paprsek.render.glow;
