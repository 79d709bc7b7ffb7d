#!/bin/sh
# Renders two scenes by the Renderer and by POV-Ray and compares them in linear light; docs/shading.md says how and why.
#   scripts/compare-povray.sh [OPTION]...
set -eu

usage() {
    cat <<'TEXT'
usage: compare-povray.sh [OPTION]...

Renders a room with mirrors and a scene of glass by the Renderer and by POV-Ray (Debian package povray), prints how much
they differ, and leaves the pictures: ours, theirs and the difference side by side in room.png and glass.png.

  -o, --output=FOLDER       where the scenes and pictures go [output/povray]
  -s, --size=WxH            pixels [320x240]
  -a, --antialiasing=N      N x N samples a pixel [4]
      --depth=N             bounces by mirrors and glass [12]
      --limit=PERCENT       mean absolute difference that is allowed, in percent of the mean [1]
      --renderer=FILE       the Renderer [the one of this build, else the one in PATH]
  -h, --help                show this help

Exit codes: 0 they agree; 1 they do not, or a program failed; 2 wrong usage; 69 no Renderer; 77 no POV-Ray.
TEXT
}
fail() { # CODE MESSAGE
    echo "compare-povray: $2" >&2
    exit "$1"
}

project=$(cd "$(dirname "$0")/.." && pwd)
output=$project/output/povray size=320x240 samples=4 depth=12 limit=1 renderer=""
while [ $# -gt 0 ]; do
    case $1 in
        -h | --help) usage; exit 0 ;;
        -o | -s | -a)
            [ $# -gt 1 ] || fail 2 "$1 wants a value"
            case $1 in -o) output=$2 ;; -s) size=$2 ;; -a) samples=$2 ;; esac
            shift ;;
        --output=*) output=${1#*=} ;;
        --size=*) size=${1#*=} ;;
        --antialiasing=*) samples=${1#*=} ;;
        --depth=*) depth=${1#*=} ;;
        --limit=*) limit=${1#*=} ;;
        --renderer=*) renderer=${1#*=} ;;
        *) fail 2 "$1: there is no such option; compare-povray.sh --help lists them" ;;
    esac
    shift
done
whole_number() { # NAME VALUE
    case $2 in '' | 0* | *[!0-9]* | ??????*) fail 2 "$1 is a whole number above 0, not '$2'" ;; esac
}
case $size in *x*) ;; *) fail 2 "--size is as in 320x240, not '$size'" ;; esac
width=${size%%x*} height=${size#*x}
whole_number --size "$width"
whole_number --size "$height"
whole_number --antialiasing "$samples"
whole_number --depth "$depth"
printf %s "$limit" | grep -Eq '^[0-9]+([.][0-9]+)?$' || fail 2 "--limit is a number, not '$limit'"

command -v povray >/dev/null 2>&1 || {
    echo "skipped: POV-Ray is not installed (package povray)"
    exit 77
}
if [ -z "$renderer" ]; then
    renderer=$project/build/release/bin/Renderer
    [ -x "$renderer" ] || renderer=Renderer
fi
command -v "$renderer" >/dev/null || fail 69 "$renderer: there is no such program; scripts/build.sh builds the Renderer"
renderer=$(command -v "$renderer")
case $renderer in /*) ;; *) renderer=$PWD/$renderer ;; esac
mkdir -p "$output" || fail 1 "$output: cannot be made"
# POV-Ray may read and write where it runs.
cd "$output"

pov() { # SCENE PASS PICTURE SAMPLES; 16 bits and no gamma: steps of 1/65535 of what is white
    povray +I"$1.pov" +O"$3.ppm" +FP16 File_Gamma=1.0 -D -A +W$((width * $4)) +H$((height * $4)) \
        Declare=Pass="$2" >"$3.log" 2>&1 || {
        tr '\r' '\n' <"$3.log" | tail -n 5 | cut -c1-200 >&2
        fail 1 "POV-Ray failed; its report is $output/$3.log"
    }
}

differ=0
for scene in room glass; do
    rm -f "$scene".pfm "$scene".png "$scene"*.ppm
    python3 "$project/scripts/povray/scenes.py" "$scene" . "$width" "$height" "$samples" "$depth" >"$scene.parts"
    "$renderer" "$scene.scn" -o "$scene.pfm" --progress=none
    pov "$scene" 0 "$scene" "$samples"
    pov "$scene" 3 "$scene-parts" 1
    if [ "$scene" = glass ]; then
        pov "$scene" 1 "$scene-own" "$samples"
        pov "$scene" 2 "$scene-dark" "$samples"
    fi
    python3 "$project/scripts/povray/compare.py" . "$scene" "$samples" "$limit" || differ=1
done
exit $differ
