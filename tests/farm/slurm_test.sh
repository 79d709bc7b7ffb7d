#!/bin/sh
# scripts/farm.sh on a real Slurm cluster of two nodes on this machine: one part is stopped and comes back, one node is
# killed with what it renders, and every frame is there at the end, with the film.
set -eu
for program in slurmctld slurmd sbatch munged ffmpeg; do
    command -v "$program" >/dev/null 2>&1 || [ -x "/usr/sbin/$program" ] || {
        echo "skipped: $program is not installed (packages slurm-wlm, munge, ffmpeg)"
        exit 77
    }
done
[ "$(id -u)" = 0 ] || {
    echo "skipped: the daemons of a cluster are started by root"
    exit 77
}
# shellcheck source=tests/farm/film.sh
. "$(dirname "$0")/film.sh"
chmod 755 "$work"
host=$(hostname -s)
pids=""
stop_cluster() {
    for file in "$work"/*.pid; do
        [ -f "$file" ] || continue
        pid=$(cat "$file")
        kill "$pid" 2>/dev/null || continue
        # It saves its state before it ends.
        tries=0
        while [ "$tries" -lt 100 ] && kill -0 "$pid" 2>/dev/null; do
            tries=$((tries + 1))
            sleep 0.1
        done
    done
    pkill -f "slurmstepd.*$work" 2>/dev/null || true
    [ "${SLURM_TEST_KEEP:-}" = 1 ] || rm -rf "$work"
}
trap stop_cluster EXIT

# Ports of its own, so that tests beside it do not meet.
port=$((20000 + $$ % 20000))
mkdir -p "$work/state" "$work/spool.n1" "$work/spool.n2" "$work/alone"
cat >"$work/slurm.conf" <<TEXT
MailProg=/bin/true
ClusterName=rt$$
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=cred_expire=5
SlurmctldPort=$port
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool.%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.%n.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerType=sched/backfill
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobRequeue=1
RequeueExit=75
MpiDefault=none
ReturnToService=2
SlurmctldTimeout=30
SlurmdTimeout=15
MinJobAge=300
NodeName=n[1-2] NodeHostname=$host NodeAddr=127.0.0.1 Port=[$((port + 1))-$((port + 2))] CPUs=1 RealMemory=500 State=UNKNOWN
PartitionName=render Nodes=n[1-2] Default=YES MaxTime=INFINITE State=UP
TEXT
export SLURM_CONF="$work/slurm.conf"
PATH=$PATH:/usr/sbin
if ! munge -n >/dev/null 2>&1; then
    mkdir -p /run/munge
    chown munge: /run/munge
    runuser -u munge -- munged
fi
slurmctld -f "$SLURM_CONF"
slurmd -N n1 -f "$SLURM_CONF"
slurmd -N n2 -f "$SLURM_CONF"
tries=0
until [ "$(sinfo --noheader --states=idle --format=%D 2>/dev/null)" = 2 ]; do
    tries=$((tries + 1))
    [ "$tries" -lt 60 ] || wrong "the cluster does not start: $(tail -n 3 "$work/slurmctld.log")"
    sleep 0.5
done

# Frames of about a second, so that there is a middle of the film.
scene=$2/data/tiny/tiny.scn
quality="-w 640 -h 480 -a 8"
write_film
# shellcheck disable=SC2086
"$farm" "$scene" "$work/film.lst" -o "$work/out/####.png" --engine=slurm --parts=8 --video="$work/film.mp4" \
    --renderer="$renderer" --wait -- $quality >"$work/farm.log" 2>&1 &
film=$!
until [ "$(find "$work/out" -name '*.png' 2>/dev/null | wc -l)" -ge 3 ]; do
    kill -0 "$film" 2>/dev/null || wrong "it ended early: $(cat "$work/farm.log")"
    sleep 0.2
done

# The step that renders a part on the node n2; nothing between two parts.
step_of_n2() {
    for step in $(pgrep -f "slurmstepd: \[.*batch\]" || true); do
        child=$(pgrep -P "$step" | head -n 1)
        if grep -qzx "SLURMD_NODENAME=n2" "/proc/$child/environ" 2>/dev/null &&
            grep -qzx "SLURM_CONF=$SLURM_CONF" "/proc/$child/environ" 2>/dev/null; then
            echo "$step"
            return
        fi
    done
}

# The node n2 dies, with the part that it renders.
until step=$(step_of_n2) && [ -n "$step" ]; do
    kill -0 "$film" 2>/dev/null || wrong "nothing ran on the node that was to die"
    sleep 0.1
done
kill -9 "$(cat "$work/slurmd.n2.pid")"
children=$(pgrep -P "$step")
kill -9 "$step" || true # before its children: a dead node does not tell how they ended
for child in $children; do pkill -9 -P "$child" || true; kill -9 "$child" || true; done
rm -f "$work/slurmd.n2.pid"
echo "killed n2 with $(find "$work/out" -name '*.png' | wc -l) of $frames frames done"

# Another part is stopped, as when something more urgent comes: it asks for another try.
pkill -TERM -f "$renderer $scene.*--chunk=" || true

wait "$film" || wrong "the film failed: $(tail -n 3 "$work/farm.log")"
check_frames
[ -s "$work/film.mp4" ] || wrong "there is no film"
[ "$(ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 "$work/film.mp4")" = "$frames" ] ||
    wrong "the film has not $frames frames"

# Folders whose names sbatch would read as patterns, or take options from.
for name in '%a %j %% $(touch RAN)' 'a\b\t' "it's
#SBATCH --wrap=touch RAN
"; do
    mkdir "$work/$name"
    cp "$work/0.cam" "$2/data/tiny/"* "$work/$name"
    echo 0.cam >"$work/$name/$name"
    "$farm" "$work/$name/tiny.scn" "$work/$name/$name" -o "$work/$name/$name####.png" --engine=slurm --renderer="$renderer" \
        --wait -- -w 4 -h 3 >"$work/farm.log" 2>&1 || wrong "the farm fails in $name: $(cat "$work/farm.log")"
    [ -s "$work/$name/${name}0001.png" ] || wrong "no frame in $name"
    [ -s "$work/$name/farm-log/part-1.log" ] || wrong "no log in $name"
done
[ -z "$(find "$work" -name 'RAN*')" ] || wrong "a name ran"
echo "all $frames frames and the film, in spite of a dead node"
