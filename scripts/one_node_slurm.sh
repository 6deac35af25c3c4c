#!/usr/bin/env bash
# Runs a command where Slurm's queue is this machine alone, and nobody else's: one_node_slurm.sh FOLDER COMMAND...
# Slurm's and munge's programs (Debian: slurmctld, slurmd, slurm-client, munge) keep everything in FOLDER and end with the command. Its
# exit code is the command's; 77 where Slurm does not start here.
set -euo pipefail
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift
export PATH=$PATH:/usr/sbin SLURM_CONF=$folder/slurm.conf
host=$(hostname -s)
mkdir -p "$folder/state" "$folder/spool"
finish() {
  for file in slurmd slurmctld munged; do
    [ ! -s "$folder/$file.pid" ] || kill "$(cat "$folder/$file.pid")" 2> /dev/null || true
  done
}
trap finish EXIT
give_up() {
  echo "Slurm does not start here: $1" >&2
  tail -n 5 "$folder"/*.log >&2 2> /dev/null || true
  exit 77
}

head -c 1024 /dev/urandom > "$folder/key"
chmod 400 "$folder/key"
munged --force --key-file="$folder/key" --socket="$folder/munge" --pid-file="$folder/munged.pid" \
  --log-file="$folder/munged.log" --seed-file="$folder/seed" > "$folder/munged.out" 2>&1 || give_up munged

# Two ports that nothing listens on.
port() { for ((p = 20000 + RANDOM % 20000; ; ++p)); do (: < "/dev/tcp/127.0.0.1/$p") 2> /dev/null || { echo "$p"; return; }; done; }
cat > "$folder/cgroup.conf" <<< "CgroupPlugin=cgroup/v1"
cat > "$SLURM_CONF" <<END
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthInfo=socket=$folder/munge
SlurmctldPort=$(port)
SlurmdPort=$(port)
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
slurmctld -i > "$folder/slurmctld.out" 2>&1 || give_up slurmctld
slurmd > "$folder/slurmd.out" 2>&1 || give_up slurmd
for ((i = 0; i < 150; ++i)); do
  state=$(sinfo --noheader --format=%T 2> /dev/null || true)
  [ "$state" != idle ] || break
  sleep 0.2
done
[ "$state" = idle ] || give_up "the node is ${state:-not known}"
"$@"
