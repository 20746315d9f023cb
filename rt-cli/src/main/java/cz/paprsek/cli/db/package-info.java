/** The commands on databases of scenes, and tables as text. */
package cz.paprsek.cli.db;
