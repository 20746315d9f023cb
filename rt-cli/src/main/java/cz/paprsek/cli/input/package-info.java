/** The words of a command line made into values: files, scenes, sizes, regions. */
package cz.paprsek.cli.input;
