/** Pictures that show something else than light. */
package cz.paprsek.render.mode;
