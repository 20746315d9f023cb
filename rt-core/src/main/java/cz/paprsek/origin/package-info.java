/** What pictures tell of where they come from. */
package cz.paprsek.origin;
