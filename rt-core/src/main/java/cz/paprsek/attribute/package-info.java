/**
 * What there is to say of the attributes of scene files, said once, at the component of the record that has them: the schema is generated from
 * it, and writer, tables, property sheet and summaries go by it. Knows no record.
 */
package cz.paprsek.attribute;
