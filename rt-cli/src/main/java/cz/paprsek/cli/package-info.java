/**
 * The command line: commands thin over the library. Only {@link cz.paprsek.cli.Main} ends the process. Right-handed world, y up, lengths in
 * scene units; degrees at the border, radians inside.
 */
package cz.paprsek.cli;
