/** Immutable lists that share what is the same, and what two of them differ in. */
package cz.paprsek.list;
