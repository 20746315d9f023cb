/** Pictures and films rendered by a cluster of Apache Spark's. */
package cz.paprsek.spark;
