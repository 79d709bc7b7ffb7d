#!/bin/sh
# Paths per second, and error at equal processor time, of the path tracer beside Cycles in one run; docs/performance.md
# has the figures.
#   scripts/performance/cycles.sh [OPTION]... [SCENE]...
# One thread each, in turns. Options: --output=FOLDER [output/cycles-speed], --size=WxH [320x240], --rounds=N [3],
# --times=S,S [10,60] processor seconds at which errors are measured (0: none), --reference=S [600] those of the image that
# they are measured against, each program's own (kept; a run that was stopped goes on), --models=FOLDER [$RT_TEST_SCENES],
# --renderer=FILE, --blender=FILE. --two-threads: instead, what a second thread brings to paths, over what it brings to
# rays in rtbench (--rtbench=FILE); in wall time, so on a machine at rest only.
# Scenes [sibenik cube sponza lamborghini nave]: those of scripts/compare-cycles.sh.
set -eu
project=$(cd "$(dirname "$0")/../.." && pwd)
output=$project/output/cycles-speed size=320x240 rounds=3 times=10,60 reference=600 models=${RT_TEST_SCENES:-}
renderer=$project/build/release/bin/Renderer blender=blender rtbench=$project/build/release/bin/rtbench scenes="" both=""
fail() { # CODE MESSAGE
    echo "cycles: $2" >&2
    exit "$1"
}
while [ $# -gt 0 ]; do
    case $1 in
        -h | --help)
            sed -n '2,11s/^# \{0,1\}//p' "$0"
            exit 0 ;;
        --output=*) output=${1#*=} ;;
        --size=*x*) size=${1#*=} ;;
        --rounds=*) rounds=${1#*=} ;;
        --times=*) times=${1#*=} ;;
        --reference=*) reference=${1#*=} ;;
        --models=*) models=${1#*=} ;;
        --renderer=*) renderer=${1#*=} ;;
        --blender=*) blender=${1#*=} ;;
        --rtbench=*) rtbench=${1#*=} ;;
        --two-threads) both=yes ;;
        -*) fail 2 "$1: there is no such option; --help lists them" ;;
        *) scenes="$scenes $1" ;;
    esac
    shift
done
command -v "$renderer" >/dev/null || fail 69 "$renderer: there is no such program; scripts/build.sh builds the Renderer"
[ -n "$both" ] || command -v "$blender" >/dev/null || fail 77 "Blender is not installed (scripts/setup.sh --peers)"
python=python3
"$python" -c "import numpy" 2>/dev/null || python=/usr/bin/python3
"$python" -c "import numpy" 2>/dev/null || fail 77 "there is no numpy for python3 (scripts/setup.sh --peers)"
mkdir -p "$output"
set -- "$output" "${size%%x*}" "${size#*x}" "$rounds"
export PYTHONDONTWRITEBYTECODE=1
scenes=${scenes:-sibenik cube sponza lamborghini nave}
echo "$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1), $(nproc) threads"
if [ -n "$both" ]; then
    # shellcheck disable=SC2086
    exec "$python" "$project/scripts/cycles/two_threads.py" "$@" "$(command -v "$renderer")" "$rtbench" "$models" $scenes
fi
# shellcheck disable=SC2086
exec "$python" "$project/scripts/cycles/measure.py" "$@" "$reference" "$times" "$(command -v "$renderer")" \
    "$(command -v "$blender")" "$models" $scenes
