#!/usr/bin/env bash
# Renders on a Slurm whose only node is this machine, with the scripts of tools/slurm, and compares
# with what one process makes. It needs root, two processors, and Debian's slurm-wlm.
#
# usage: tests/slurm/run.sh PATH/TO/lapidary
set -euo pipefail

lapidary=$(realpath "$1")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

die() {
  echo "slurm: $*" >&2
  exit 1
}

[ "$(id -u)" = 0 ] || die "the daemons of Slurm need root"
for program in slurmctld slurmd sbatch srun; do
  command -v "$program" >/dev/null || die "there is no $program: install slurm-wlm"
done

work=$(mktemp -d)
daemons=()
clean_up() {
  # In the order in which they began, and only these.
  for pid in "${daemons[@]}"; do kill "$pid" 2>/dev/null || true; done
  for pid in "${daemons[@]}"; do wait "$pid" 2>/dev/null || true; done
  rm -rf "$work"
}
trap clean_up EXIT

# Nobody is asked who is who, and only this machine is spoken to.
host=$(hostname -s)
export SLURM_CONF=$work/slurm.conf
cat >"$SLURM_CONF" <<CONF
ClusterName=loopback
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmUser=root
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmdPidFile=$work/slurmd.pid
SlurmctldPidFile=$work/slurmctld.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
MpiDefault=none
KillWait=30
NodeName=$host NodeAddr=127.0.0.1 Port=16901 CPUs=2
PartitionName=all Nodes=$host Default=YES State=UP MaxTime=INFINITE
CONF
mkdir "$work/state" "$work/spool"
srun --mpi=list 2>&1 | grep -q pmix || die "this Slurm has no PMIx"
slurmctld -D &
daemons+=($!)
slurmd -D &
daemons+=($!)
for ((i = 0; i < 60; ++i)); do
  [ "$(sinfo -h -t idle -o %D 2>/dev/null)" = 1 ] && break
  sleep 0.5
done
[ "$(sinfo -h -t idle -o %D)" = 1 ] || die "the node does not come up: $(cat "$work"/slurm*.log)"

cd "$work"
mkdir frames
# Two tasks on one node instead of one on each of four.
sed 's/--nodes=4/--nodes=1/; s/tasks-per-node=1/tasks-per-node=2/; /--exclusive/d' "$root/tools/slurm/picture.sh" >picture.sh
sed '/--exclusive/d' "$root/tools/slurm/frames.sh" >frames.sh
PATH=$(dirname "$lapidary"):$PATH
cat >scene.lua <<'LUA'
return scene {
  camera = perspective { from = {0, -5, 2.5}, at = {0, 0, 0.3}, fov = 40 },
  lights = { sphere_light { center = {-2, 1, 4}, radius = 0.3, power = 300 } },
  objects = {
    plane { material = matte { color = {0.6, 0.6, 0.6} } },
    sphere { center = {0, 0, 0.8 + 0.1 * frame}, radius = 0.8, material = glass "N-BK7" },
  },
  render = { size = {80, 60} },
}
LUA

without_seconds() {
  python3 -c 'import re, sys
data = open(sys.argv[1], "rb").read()
sys.stdout.buffer.write(re.sub(rb"seconds\0double\0.{12}", b"", data, flags=re.S))' "$1"
}
same() {
  cmp <(without_seconds "$1") <(without_seconds "$2") ||
    die "$1 and $2 are not the same"
  echo "slurm: $1 and $2 are the same"
}
export LC_ALL=C

lapidary render scene.lua -o one.exr --samples 72 --threads 1 --quiet
sbatch --wait -o picture.log picture.sh scene.lua two.exr --samples 72 --threads 1 \
  --stats stats.json || die "$(cat picture.log)"
grep -q '"ranks": 2' stats.json || die "there were not two ranks: $(cat picture.log)"
same one.exr two.exr

sbatch --wait -o frames.%a.log --array=1-3 frames.sh scene.lua frames --samples 8 --threads 1 ||
  die "$(cat frames.*.log)"
for frame in 1 2 3; do
  lapidary render scene.lua -o one.exr --samples 8 --threads 1 --quiet --frame $frame
  same one.exr "frames/000$frame.exr"
done

# Without PMIx the processes cannot find each other: Open MPI refuses.
if srun -n 2 --mpi=none lapidary render scene.lua -o alone.exr --samples 4 --quiet 2>alone.log; then
  die "two processes rendered one picture each"
fi
[ ! -e alone.exr ] || die "there is a picture: $(cat alone.log)"

# A job whose time is over keeps what there is, and goes on.
job=$(sbatch --parsable -o stop.log picture.sh scene.lua stop.exr --samples 16000000 --threads 1)
for ((i = 0; i < 120; ++i)); do
  grep -q "samples per pixel" stop.log 2>/dev/null && break
  sleep 0.5
done
scancel --signal=TERM "$job"
for ((i = 0; i < 120; ++i)); do
  [ -z "$(squeue -h -j "$job")" ] && break
  sleep 0.5
done
grep -q "resume goes on with it" stop.log || die "no checkpoint: $(cat stop.log)"
lapidary render scene.lua -o stop.exr --samples 1 --resume --threads 1 2>&1 | grep "going on from"
echo "slurm: done"
