/** What is in a scene. */
package cz.paprsek.cli.describe;
