#!/bin/sh
# The thesis' Table 8.1 again: four views at 320 x 240, drawn over and over by RTServer itself, with all threads and
# with one; then the same for real models, when there are any.
#   scripts/performance/run.sh [--seconds S] [MODEL|SCENE]...     Without models: those of $RT_TEST_SCENES, if it is set.
# A frame's time is measured from one published frame to the next. Build first: scripts/build.sh.
set -eu
cd "$(dirname "$0")/../.."
bin=build/release/bin
seconds=3
while [ $# -gt 0 ]; do
    case $1 in
    --seconds)
        seconds=$2
        shift 2
        ;;
    --help)
        sed -n 's/^# \{0,1\}//; 2,4p' "$0"
        exit 0
        ;;
    *) break ;;
    esac
done
for program in RTServer CUI; do
    [ -x $bin/$program ] || {
        echo "performance: $bin/$program is not there; scripts/build.sh builds it" >&2
        exit 1
    }
done

instance=performance-$$
folder=$(mktemp -d)
stop() { $bin/CUI -i $instance exit >/dev/null 2>&1 || true; }
trap 'stop; rm -rf "$folder"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

value() { sed "s/.*\"$1\":\([^,}]*\).*/\1/" "$folder/status"; }

# measure <threads> <scene> [options]: leaves ms, fps, polygons.
measure() {
    threads=$1
    shift
    $bin/RTServer "$@" --instance=$instance --resolution=320x240 --threads="$threads" --daemon 2>"$folder/log" || {
        cat "$folder/log" >&2
        exit 1
    }
    $bin/CUI -i $instance wait-idle
    sleep 1 # an exact tree may still be on its way
    $bin/CUI -i $instance idle off
    sleep "$seconds"
    $bin/CUI -i $instance status --json >"$folder/status"
    stop
    fps=$(value framesPerSecond)
    polygons=$(value polygons)
    ms=$(awk "BEGIN { printf \"%.2f\", 1000 / $fps }")
}

# row <name> <the thesis' ms, or -> <scene> [options]
row() {
    name=$1
    thesis=$2
    shift 2
    measure 1 "$@"
    one=$ms
    measure 0 "$@"
    awk "BEGIN { printf \"%-34s %8s %9s %8.1f %12s %10d\\n\", \"$name\", \"$thesis\", \"$ms\", $fps, \"$one\", $polygons }"
}

echo "$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1), $(nproc) threads; 320 x 240"
printf '%-34s %8s %9s %8s %12s %10s\n' view 'thesis' 'ms' 'FPS' '1 thread, ms' polygons
row "looking at the elephant" 60 data/organic/organic.scn --camera=data/organic/portrait.cam
row "inside the nave" 100 data/nave/nave.scn --camera=data/nave/aisle.cam
row "looking at a mirror" 130 data/mirrors/mirrors.scn --camera=data/mirrors/curved.cam
row "in the middle of the scene" 220 data/organic/organic.scn --camera=data/organic/shore.cam

if [ $# -eq 0 ] && [ -n "${RT_TEST_SCENES:-}" ]; then
    set -- "$RT_TEST_SCENES/sibenik/sibenik.obj" "$RT_TEST_SCENES/sponza_crytek/sponza.obj" \
        "$RT_TEST_SCENES/bunny/bunny.obj" "$RT_TEST_SCENES/dragon/dragon.ply"
fi
for model in "$@"; do
    if [ -e "$model" ]; then
        # By default a model is lit by a sky; the figures are those of the light beside the viewer.
        case $model in
        *.scn) row "$(basename "$model")" - "$model" ;;
        *) row "$(basename "$model"), headlight" - "$model" --look=headlight ;;
        esac
    else
        echo "performance: $model is not there" >&2
    fi
done
