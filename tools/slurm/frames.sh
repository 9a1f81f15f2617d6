#!/bin/bash
#SBATCH --nodes=1
#SBATCH --ntasks=1
#SBATCH --exclusive
#SBATCH --signal=B:TERM@120
#SBATCH --requeue

# sbatch --array=1-240 frames.sh SCENE FOLDER [OPTIONS]: a picture for each frame
# (docs/many_machines.md).
frame=$SLURM_ARRAY_TASK_ID
exec lapidary render "$1" -o "$(printf '%s/%04d.exr' "$2" "$frame")" --set frame="$frame" --resume \
  "${@:3}"
