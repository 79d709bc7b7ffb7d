#!/bin/sh
# In the place of sbatch: runs the script of its standard input at once, for each index of --array. No name may be in an
# option, where sbatch looks for patterns, nor where it looks for options in the script.
set -eu
array=1-1
for option in "$@"; do
    case $option in
        *[!A-Za-z0-9\ ./:=_-]*) echo "sbatch: a name is in $option" >&2; exit 1 ;;
        --array=*) array=${option#*=} ;;
    esac
done
script=$(mktemp)
trap 'rm -f "$script"' EXIT
cat >"$script"
if sed '1d;/^[^#]/,$d' "$script" | grep -q '^#SBATCH'; then
    echo "sbatch: the script has an option of its own" >&2
    exit 1
fi
cd /
for index in $(seq "${array%-*}" "${array#*-}"); do
    SLURM_ARRAY_TASK_ID=$index sh "$script" || true
done
echo 7
