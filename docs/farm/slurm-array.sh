#!/bin/sh
#SBATCH --job-name=halo
#SBATCH --array=1-64
#SBATCH --cpus-per-task=8
#SBATCH --mem=4G
#SBATCH --time=12:00:00
#SBATCH --signal=TERM@120
#SBATCH --requeue
#SBATCH --open-mode=append
# SPDX-License-Identifier: Apache-2.0
# One slice of a scene for each task of a Slurm array:
#   sbatch --array=1-64 slurm-array.sh SCENE.toml FOLDER
# A task that is stopped before its end, by its time limit or by the farm, is queued again and goes on from its tally.
set -u
scene=${1:?the scene}
folder=${2:?the folder for the tallies}
tally=$folder/slice-$SLURM_ARRAY_TASK_ID.tally.exr

srun parhelion trace "$scene" --slice "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --resume "$tally" \
  --checkpoint 10min --nthreads "$SLURM_CPUS_PER_TASK" --progress json
status=$?
[ $status -ne 75 ] || scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
exit $status
