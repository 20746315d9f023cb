/** Scenes to measure with. Not offered to everybody: they may change with what is to be measured. */
package cz.paprsek.standard;
