/**
 * What a scene needs beside its own file: pictures, and what else it names. Only what lies in the folder of the scene, or is handed in, can be read; and
 * once only, so that all parts of a picture see the same.
 */
package cz.paprsek.asset;
