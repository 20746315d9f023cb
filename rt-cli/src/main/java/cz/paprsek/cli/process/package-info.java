/** What every command shares: the process's streams, its exit codes, the wish to stop, and how a failure becomes one line. */
package cz.paprsek.cli.process;
