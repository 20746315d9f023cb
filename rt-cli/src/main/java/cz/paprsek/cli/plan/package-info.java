/** What clusters are told, so that each machine renders a share of a picture and one puts it together: scripts for Slurm, manifests for Kubernetes. */
package cz.paprsek.cli.plan;
