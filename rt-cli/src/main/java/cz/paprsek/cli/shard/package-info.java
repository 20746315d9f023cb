/** A picture made by several machines: its work dealt out, each share rendered into files of its own, and those put together to the same bytes as one machine's. */
package cz.paprsek.cli.shard;
