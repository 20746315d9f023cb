/** What pictures may show, other than light. */
package cz.paprsek.render.mode;
