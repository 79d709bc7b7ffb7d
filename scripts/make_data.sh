#!/usr/bin/env bash
# Makes the models and pictures of data/ that are missing or older than the scripts that make them.
# Usage: scripts/make_data.sh [--force]     Needs python3 (3.9 or later), nothing else. Two run at a time.
set -euo pipefail

data="$(cd "$(dirname "${BASH_SOURCE[0]}")/../data" && pwd)"
force=0
case "${1:-}" in
    "") ;;
    --force) force=1 ;;
    *) echo "usage: make_data.sh [--force]" >&2; exit 2 ;;
esac

# fresh <folder> <output>: the output stands and no script that it depends on is newer.
fresh() {
    local output="$data/$1/generated/$2"
    local scripts=("$data/tools" "$data/environments" "$data/$1")
    [[ $force -eq 0 && -s "$output" ]] &&
        [[ -z "$(find "${scripts[@]}" -name '*.py' -newer "$output" -print -quit)" ]]
}

# make <folder> <output>: runs data/<folder>/make_<folder>.py; its last file written is <output>.
make() {
    local started=$SECONDS
    if fresh "$1" "$2"; then
        echo "data/$1: up to date"
        return
    fi
    echo "data/$1: making ..."
    PYTHONDONTWRITEBYTECODE=1 python3 "$data/$1/make_$1.py" | sed "s/^/  /"
    echo "data/$1: made in $((SECONDS - started)) s"
}

export -f make fresh
export data force
printf '%s\n' "organic organic.glb" "environments night.hdr" "nave nave.glb" "mirrors mirrors.glb" |
    xargs -P 2 -L 1 bash -euo pipefail -c 'make "$0" "$1"'
