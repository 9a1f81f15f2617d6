#!/bin/bash
#SBATCH --nodes=1
#SBATCH --ntasks=1
#SBATCH --exclusive
#SBATCH --signal=B:TERM@120
#SBATCH --requeue

# sbatch --array=1-240 frames.sh SCENE FOLDER [OPTIONS]: a picture for each frame
# (docs/many_machines.md).
exec lapidary render "$1" -o "$2/####.exr" --frame "$SLURM_ARRAY_TASK_ID" --resume "${@:3}"
