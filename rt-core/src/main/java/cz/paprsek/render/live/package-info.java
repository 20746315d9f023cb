/** Pictures that follow a scene that changes. */
package cz.paprsek.render.live;
