/** What holds for scene files whoever reads or writes them: limits, the schema, the names of colours. */
package cz.paprsek.xml.format;
