/** Scenes in which something moves, for the editor: the time that is looked at, keys, ways. Knows no window. Times in seconds, frames from 1. */
package cz.paprsek.fx.model.motion;
