/** The commands that measure: how fast, and how far apart two pictures are. */
package cz.paprsek.cli.bench;
