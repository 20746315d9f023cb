/**
 * What there is to say of the elements and attributes of scene files, said once, at the records that have them and at their components: the schema
 * is generated from it, and readers, writer, tables, property sheet and summaries go by it. Knows no record.
 */
@NullMarked
package cz.paprsek.attribute;

import org.jspecify.annotations.NullMarked;
