/** Who renders: threads, and what they keep from one picture to the next. */
package cz.paprsek.render.work;
