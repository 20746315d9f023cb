/** The command line: one class for each command, thin over the library. Only {@link cz.paprsek.cli.Main} ends the process. */
package cz.paprsek.cli;
