#!/bin/sh
# Renders scenes by the path tracer and by Blender's Cycles and compares them in linear light; docs/shading.md says how.
#   scripts/compare-cycles.sh [OPTION]... [SCENE]...
set -eu

usage() {
    cat <<'TEXT'
usage: compare-cycles.sh [OPTION]... [SCENE]...

Renders scenes by the Renderer's path tracer and by Cycles (Debian package blender; scripts/setup.sh --peers), one
thread each, prints how much they differ, and leaves the images: ours, theirs and the difference side by side in
SCENE.png. Images that are there and still right are not rendered again, so that a run that was stopped goes on.

Scenes: plane-point plane-directional plane-sphere plane-rectangle plane-emission plane-background (a floor lit by one
light, directly: strengths), cube sky sun mirrors glass tinted frosted metals whites (generated), cornell sibenik
sponza (of the folder of models); not among those taken without a name: furnished, lamborghini, and nave of
scripts/make_data.sh (or the file $RT_NAVE).

  -o, --output=FOLDER       where scenes and images go [output/cycles]
  -s, --size=WxH            pixels [320x240]
  -n, --samples=N           samples per pixel [256]
      --models=FOLDER       well-known models [$RT_TEST_SCENES]
      --limit=PERCENT       difference of the means that is allowed beyond noise [1]
      --renderer=FILE       the Renderer [the one of this build, else the one in PATH]
      --blender=FILE        Blender 3.4 [blender]
  -h, --help                show this help

Exit codes: 0 they agree; 1 they do not, or a program failed; 2 wrong usage; 69 no Renderer; 77 no Blender or no numpy.
TEXT
}
fail() { # CODE MESSAGE
    echo "compare-cycles: $2" >&2
    exit "$1"
}

project=$(cd "$(dirname "$0")/.." && pwd)
output=$project/output/cycles size=320x240 samples=256 limit=1 renderer="" blender=blender models=${RT_TEST_SCENES:-} scenes=""
while [ $# -gt 0 ]; do
    case $1 in
        -h | --help) usage; exit 0 ;;
        -o | -s | -n)
            [ $# -gt 1 ] || fail 2 "$1 wants a value"
            case $1 in -o) output=$2 ;; -s) size=$2 ;; -n) samples=$2 ;; esac
            shift ;;
        --output=*) output=${1#*=} ;;
        --size=*) size=${1#*=} ;;
        --samples=*) samples=${1#*=} ;;
        --models=*) models=${1#*=} ;;
        --limit=*) limit=${1#*=} ;;
        --renderer=*) renderer=${1#*=} ;;
        --blender=*) blender=${1#*=} ;;
        -*) fail 2 "$1: there is no such option; compare-cycles.sh --help lists them" ;;
        *) scenes="$scenes $1" ;;
    esac
    shift
done
whole_number() { # NAME VALUE
    case $2 in '' | 0* | *[!0-9]* | ???????*) fail 2 "$1 is a whole number above 0, not '$2'" ;; esac
}
case $size in *x*) ;; *) fail 2 "--size is as in 320x240, not '$size'" ;; esac
whole_number --size "${size%%x*}"
whole_number --size "${size#*x}"
whole_number --samples "$samples"
printf %s "$limit" | grep -Eq '^[0-9]+([.][0-9]+)?$' || fail 2 "--limit is a number, not '$limit'"
if [ -z "$scenes" ]; then
    scenes="plane-point plane-directional plane-sphere plane-rectangle plane-emission plane-background
        cube sky sun mirrors glass tinted frosted metals whites cornell sibenik sponza"
fi
for scene in $scenes; do
    case $scene in
        plane-point | plane-directional | plane-sphere | plane-rectangle | plane-emission | plane-background) ;;
        cube | sky | sun | mirrors | glass | tinted | frosted | metals | whites | furnished | cornell | sibenik | sponza | lamborghini | nave) ;;
        *) fail 2 "$scene: there is no such scene; compare-cycles.sh --help lists them" ;;
    esac
done

command -v "$blender" >/dev/null 2>&1 || {
    echo "skipped: Blender is not installed (scripts/setup.sh --peers)"
    exit 77
}
python=""
for candidate in python3 /usr/bin/python3; do
    if [ -z "$python" ] && "$candidate" -c "import numpy" 2>/dev/null; then python=$candidate; fi
done
[ -n "$python" ] || {
    echo "skipped: there is no numpy for python3 (scripts/setup.sh --peers)"
    exit 77
}
if [ -z "$renderer" ]; then
    renderer=$project/build/release/bin/Renderer
    [ -x "$renderer" ] || renderer=Renderer
fi
command -v "$renderer" >/dev/null || fail 69 "$renderer: there is no such program; scripts/build.sh builds the Renderer"
mkdir -p "$output" || fail 1 "$output: cannot be made"
# shellcheck disable=SC2086
PYTHONDONTWRITEBYTECODE=1 exec "$python" "$project/scripts/cycles/compare.py" "$output" "${size%%x*}" "${size#*x}" "$samples" \
    "$limit" "$(command -v "$renderer")" "$(command -v "$blender")" "$models" $scenes
