/** What stands in one option: a size, a share, the name of a mode. */
package cz.paprsek.cli.value;
