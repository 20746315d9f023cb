/** What the commands say of themselves, for other programs: pages for man, completion for shells. */
package cz.paprsek.cli.manual;
