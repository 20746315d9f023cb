/** What is in a scene, and what in it is hardly meant. */
package cz.paprsek.cli.describe;
