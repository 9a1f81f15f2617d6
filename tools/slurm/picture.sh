#!/bin/bash
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=1
#SBATCH --exclusive
#SBATCH --time=04:00:00
#SBATCH --signal=TERM@120
#SBATCH --requeue

# sbatch picture.sh SCENE PICTURE [OPTIONS]: one picture on many nodes (docs/many_machines.md).
exec srun --mpi=pmix --cpu-bind=none --kill-on-bad-exit=1 \
  lapidary render "$1" -o "$2" --resume "${@:3}"
