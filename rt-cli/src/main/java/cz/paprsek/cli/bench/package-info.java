/** The commands that measure: how fast, and how far apart two pictures are. The only place that starts another program. */
package cz.paprsek.cli.bench;
