/** What a camera sees the world with: one class for each lens. */
package cz.paprsek.render.eye;
