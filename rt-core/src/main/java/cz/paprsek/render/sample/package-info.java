/** Where a pixel's rays go through, and the random numbers of lens, time and lights. */
package cz.paprsek.render.sample;
