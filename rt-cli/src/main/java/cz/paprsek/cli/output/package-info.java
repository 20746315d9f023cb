/** From scenes to pictures in files: where each goes, how far it is, what is kept of it when it is interrupted, and what is told of it. */
package cz.paprsek.cli.output;
