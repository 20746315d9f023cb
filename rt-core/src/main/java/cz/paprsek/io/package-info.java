/** What reading and writing of all kinds of file have in common. Knows nothing of scenes or pictures. */
package cz.paprsek.io;
