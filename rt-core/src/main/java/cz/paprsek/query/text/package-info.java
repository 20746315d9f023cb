/** Tables as text. */
package cz.paprsek.query.text;
