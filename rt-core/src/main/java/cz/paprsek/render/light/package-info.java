/** Lights as points of surfaces see them: one class for each kind. */
package cz.paprsek.render.light;
