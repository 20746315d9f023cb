/** How pictures are made that show something else than light. */
package cz.paprsek.render.show;
