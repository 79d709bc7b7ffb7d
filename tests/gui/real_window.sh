#!/bin/sh
# The window on a real X server, driven by keys and mouse as a person would: it walks, it turns, switches light and
# bloom, exports, is resized; Ctrl+S saves only while the keyboard is not captured, Ctrl+N asks for a server, Alt+1 is a bookmark's always;
# and whether it is closed or killed, nothing is left behind once nobody looks.
#   real_window.sh FOLDER-OF-PROGRAMS MODEL [PICTURES]     77: the tools are missing
set -eu
for tool in Xvfb xdotool import compare; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is missing"; exit 77; }
done
programs=$1 model=$2 pictures=${3:-}
work=$(mktemp -d)
name=real-$$
export HOME=$work XDG_RUNTIME_DIR=$work XDG_CONFIG_HOME=$work/config XDG_CACHE_HOME=$work/cache QT_QPA_PLATFORM=xcb
chmod 700 "$work"
Xvfb -displayfd 3 -screen 0 1000x700x24 -nolisten tcp 3>"$work/display" >/dev/null 2>&1 &
xvfb=$!
window=
finish() {
    code=$?
    [ -z "$window" ] || kill "$window" 2>/dev/null || true
    wait "$window" 2>/dev/null || true
    if [ "$code" != 0 ] && [ -s "$work/display" ]; then import -window root "${TMPDIR:-/tmp}/real_window_failed.png" || true; fi
    kill "$xvfb" 2>/dev/null || true
    [ -z "$pictures" ] || { mkdir -p "$pictures"; cp "$work"/*.png "$pictures" 2>/dev/null || true; }
    rm -rf "$work"
    exit "$code"
}
trap finish EXIT
trap 'exit 1' INT TERM

fail() { echo "FAILED: $1" >&2; cat "$work/out" >&2; exit 1; }
# Until the command succeeds: 20 s at most.
comes() {
    what=$1 n=0
    shift
    while ! "$@" >/dev/null 2>&1; do
        n=$((n + 1))
        [ "$n" -lt 200 ] || fail "$what"
        sleep 0.1
    done
}
status() { "$programs/CUI" --instance="$name" status; }
answer() { "$programs/CUI" --instance="$name" "$@"; }
changed() { [ "$(answer $asked)" != "$before" ]; }
is() { [ "$(answer $asked)" = "$before" ]; }
written() { [ -s "$work/$1" ]; }
eye() { status | grep -E "^(eye|forward):"; }
idle() { status | grep -q "state: complete"; }
moved() { [ "$(eye)" != "$before" ]; }
shot() { import -window root "$work/$1.png"; }
differ() { ! compare -metric AE "$work/$1.png" "$work/$2.png" null: 2>/dev/null; }
dialog() { xdotool search --onlyvisible --name "Start new server|Replace a file|Save the scene"; }
settle() { comes "$1 comes to rest" idle; sleep 0.3; }

comes "an X server" test -s "$work/display"
DISPLAY=:$(cat "$work/display")
export DISPLAY
"$programs/GUI" "$model" --instance="$name" 2>"$work/out" &
window=$!
comes "the model" idle
main=$(xdotool search --onlyvisible --name "rtsuite" | tail -1)
xdotool windowfocus --sync "$main"
settle "the model"
shot start

before=$(eye)
xdotool keydown w; sleep 0.3; xdotool keyup w
comes "W moves" moved
settle "walking"
shot walked
differ start walked || fail "the picture does not change when the camera moves"

before=$(eye)
xdotool keydown Caps_Lock keydown Left; sleep 0.3; xdotool keyup Left keyup Caps_Lock
comes "CapsLock and Left turn" moved
xdotool key Caps_Lock
settle "turning"

# A key that switches something, twice.
toggles() {
    asked=$2 before=$(answer $2)
    xdotool key "$1"
    comes "the key $1 changes $2" changed
    xdotool key "$1"
    comes "the key $1 changes $2 back" is
}
toggles 1 lights
toggles b "get bloom"
xdotool key e
comes "E exports the camera" written camera-0001.cam
xdotool key h
comes "H exports it for high quality" written camera-0002.cam
grep -q 1920 "$work/camera-0002.cam" || fail "H exports in high quality"
xdotool key F12
comes "F12 writes the picture" written screenshot-0001.png
before=$(status | grep resolution:)
xdotool windowsize --sync "$main" 700 500
resized() { [ "$(status | grep resolution:)" != "$before" ]; }
comes "the frames follow the window's size" resized
settle "resizing"

xdotool mousemove --window "$main" 400 300 click 1
sleep 0.3
before=$(eye)
xdotool mousemove_relative 40 10
comes "the mouse turns" moved
before=$(eye)
xdotool keydown ctrl keydown s; sleep 0.3; xdotool keyup s keyup ctrl
comes "Ctrl and S crawl while captured" moved
if dialog >/dev/null; then fail "Ctrl+S opens a dialog though the keyboard is captured"; fi
asked=lights before=$(answer lights)
xdotool key alt+1
sleep 0.5
is || fail "Alt+1 switches a light while captured"
xdotool key Escape
settle "crawling"
xdotool keydown w keydown ctrl keydown d; sleep 0.3; xdotool keyup d keyup ctrl keyup w
settle "crawling aside"
before=$(eye)
xdotool keydown s; sleep 0.2; xdotool keyup s
comes "Ctrl+D leaves no server while W is down" moved
settle "walking back"
before=$(eye)
xdotool mousemove_relative 60 0
sleep 0.5
if moved; then fail "the mouse turns though it was given back"; fi
xdotool key ctrl+n
comes "Ctrl+N opens the dialog" dialog
shot dialog

xdotool key Escape

# A second window looks on. It stays when the first one is killed, and the server with it; then nobody does.
"$programs/GUI" --connect --instance="$name" 2>>"$work/out" &
second=$!
two() { [ "$(xdotool search --onlyvisible --name "rtsuite" | wc -l)" = 2 ]; }
comes "a second window, titled by the scene" two
sleep 0.5
kill -KILL "$window"
wait "$window" 2>/dev/null || true
window=$second
sleep 1
answer ping >/dev/null || fail "the server ends though a window looks at it"
kill -TERM "$window"
code=0
wait "$window" || code=$?
window=
[ "$code" = 143 ] || fail "exit code $code after SIGTERM"
comes "the server ends with its window" sh -c "! '$programs/CUI' --instance='$name' --timeout=1 ping"
echo "passed"
