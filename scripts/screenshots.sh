#!/bin/sh
# Takes pictures of the window and of each dialog, light and dark, in English and in Czech, at scale 1 and 2, on a screen
# of its own (Xvfb). Those that the manual and the README show go to docs/images.
#   scripts/screenshots.sh [--docs] [FOLDER]     by default output/screenshots; --docs: renew docs/images, too
# Build first: scripts/build.sh, and make the nave: scripts/make_data.sh. LOOKS="dark-cs-1 ..." in the environment: only these.
set -eu
cd "$(dirname "$0")/.."
docs=no
if [ "${1:-}" = --docs ]; then
    docs=yes
    shift
fi
pictures=${1:-output/screenshots}
bin=$PWD/build/release/bin
scenes=$PWD/data/nave
for tool in Xvfb xdotool import convert; do
    command -v "$tool" >/dev/null || { echo "screenshots: $tool is missing (scripts/packages-tests.txt)" >&2; exit 1; }
done
[ -s "$scenes/generated/nave.glb" ] || { echo "screenshots: $scenes/generated/nave.glb is missing; scripts/make_data.sh makes it" >&2; exit 1; }
[ -x "$bin/GUI" ] || { echo "screenshots: $bin/GUI is missing; scripts/build.sh builds it" >&2; exit 1; }
mkdir -p "$pictures"
work=$(mktemp -d)
name=nave-$$
mine=/tmp/pictures # the folder that the dialogs show
mkdir "$mine" 2>/dev/null || mine=$work
export XDG_RUNTIME_DIR="$work" XDG_DATA_HOME="$work/data" XDG_CONFIG_HOME="$work/config" XDG_CACHE_HOME="$work/cache" QT_QPA_PLATFORM=xcb LC_ALL=C.UTF-8
Xvfb -displayfd 3 -screen 0 2400x1700x24 -nolisten tcp 3>"$work/display" >/dev/null 2>&1 &
xvfb=$!
window=""
finish() {
    code=$?
    trap - EXIT
    [ -z "$window" ] || kill "$window" 2>/dev/null || true
    "$bin/CUI" --instance="$name" exit >/dev/null 2>&1 || "$bin/CUI" --instance="$name" free >/dev/null 2>&1 || true # killed for a picture
    kill "$xvfb" 2>/dev/null || true
    rm -rf "$work"
    [ "$mine" != /tmp/pictures ] || rm -rf "$mine"
    exit "$code"
}
trap finish EXIT
trap 'exit 130' INT TERM
while [ ! -s "$work/display" ]; do sleep 0.1; done
DISPLAY=:$(cat "$work/display")
export DISPLAY
cui() { "$bin/CUI" --instance="$name" "$@"; }

# The newest window beside the main one.
front() { xdotool search --onlyvisible --pid "$window" 2>/dev/null | grep -v "^$main\$" | tail -1; }

# dialog FILE KEYS...: presses the keys, takes a picture of what appears, closes it.
dialog() {
    file=$1
    shift
    xdotool windowfocus --sync "$main"
    for keys in "$@"; do
        xdotool key --clearmodifiers "$keys"
        sleep 0.3
    done
    sleep 0.7
    shown=$(front)
    [ -n "$shown" ] || { echo "screenshots: $file did not appear" >&2; return; }
    xdotool windowfocus "$shown" || true
    sleep 0.2
    import -window "$shown" "$pictures/$file.png"
}
close_dialog() {
    xdotool key --clearmodifiers Escape
    sleep 0.3
}

keys() {
    xdotool windowfocus --sync "$main"
    for each in "$@"; do
        xdotool key --clearmodifiers "$each"
        sleep 0.4
    done
}
whole_window() {
    sleep 1
    cui wait-idle >/dev/null 2>&1 || true
    sleep 0.5
    import -window "$main" "$pictures/$1-$suffix.png"
}

# The dialogs that start jobs, with all of their options; the queue with two jobs; the result of the first.
job_dialogs() {
    more="alt+m"
    [ "$language" = en ] || more="alt+d"
    dialog "build-$suffix" ctrl+alt+b
    close_dialog
    dialog "render-$suffix" ctrl+alt+r
    xdotool key --clearmodifiers "$more"
    sleep 0.5
    import -window "$(front)" "$pictures/render-more-$suffix.png"
    xdotool key --clearmodifiers "$more" Return
    sleep 1
    dialog "render2-$suffix" ctrl+alt+r
    xdotool key --clearmodifiers Return
    whole_window jobs
    while pgrep -P "$window" -x Renderer >/dev/null; do sleep 0.5; done
    whole_window jobs-done
    dialog "picture-$suffix" ctrl+j ctrl+j Return
    close_dialog
}

# Bookmarks, lights and their marks, the model, settings; the sky last, which stays.
panels() {
    for each in altar rose; do
        cui load camera "$scenes/$each.cam"
        cui wait-idle
        keys ctrl+b
        sleep 1
    done
    keys ctrl+j F7
    whole_window bookmarks
    keys F6 F9
    whole_window lights
    keys F9 F8
    whole_window model
    keys F5
    whole_window settings
    cui sky hour 17
    keys F6
    whole_window sky
}

# look THEME LANGUAGE SCALE: all pictures of one look.
look() {
    theme=$1 language=$2 scale=$3
    suffix=$theme-$language-$scale
    mkdir -p "$work/config/rtsuite"
    printf '[display]\ntheme=%s\nlanguage=%s\n[render]\nprogressive=false\nstillPathSamples=64\n[files]\nrecent=%s\npictureFolder=%s\n' \
        "$theme" "$language" data/nave/nave.scn "$mine" >"$work/config/rtsuite/GUI.ini"
    "$bin/RTServer" "$scenes/nave.scn" --instance="$name" --resolution=1024x621 --daemon 2>/dev/null
    QT_SCALE_FACTOR=$scale "$bin/GUI" --connect --instance="$name" 2>"$work/gui.txt" &
    window=$!
    main=none
    until main=$(front) && [ -n "$main" ]; do
        main=none
        sleep 0.2
    done
    sleep 1
    cui wait-idle
    cui walk
    cui wait-idle
    sleep 1
    xdotool windowfocus --sync "$main"
    import -window "$main" "$pictures/window-$suffix.png"
    keys F2
    whole_window orbit
    keys F2
    about="alt+h a" sharing="alt+f b" stop_sharing=alt+t
    menus="f e v c l n w s h"
    if [ "$language" = cs ]; then
        about="alt+v o" sharing="alt+s h" stop_sharing=alt+u
        menus="s a h k t y o e v"
    fi
    for menu in $menus; do
        xdotool windowfocus --sync "$main"
        xdotool key --clearmodifiers "alt+$menu"
        sleep 0.5
        import -window root -crop "$((700 * scale))x$((350 * scale))+0+0" +repage "$pictures/menu-$menu-$suffix.png"
        xdotool key Escape Escape
        sleep 0.2
    done
    for each in start:ctrl+n connect:ctrl+shift+o export:ctrl+e recording:ctrl+shift+r statistics:ctrl+t log:ctrl+l keys:F1 \
        angle:ctrl+shift+f save:ctrl+shift+s; do
        dialog "${each%%:*}-$suffix" "${each##*:}"
        close_dialog
    done
    # From the menu: before and after the links are there.
    # shellcheck disable=SC2086
    dialog "share-plan-$suffix" $sharing
    xdotool key --clearmodifiers Return
    sleep 2
    import -window "$(front)" "$pictures/share-$suffix.png"
    xdotool key --clearmodifiers "$stop_sharing"
    close_dialog
    # shellcheck disable=SC2086
    dialog "about-$suffix" $about
    close_dialog
    dialog "configure1-$suffix" ctrl+comma
    for page in 2 3 4; do
        xdotool key --clearmodifiers ctrl+Tab
        sleep 0.4
        import -window "$(front)" "$pictures/configure$page-$suffix.png"
    done
    close_dialog
    if [ "$docs" = yes ] && [ "$suffix" = light-en-1 ]; then still; fi
    job_dialogs
    panels
    kill -KILL "$(cui status | sed -n 's/^process: //p')"
    sleep 2
    whole_window died
    kill "$window"
    wait "$window" || true
    window=""
}

# The window with its picture rendered in higher quality.
still() {
    xdotool windowfocus --sync "$main"
    xdotool key --clearmodifiers ctrl+r
    sleep 2
    while pgrep -P "$window" -x Renderer >/dev/null; do sleep 0.5; done
    sleep 7 # until the note is gone
    import -window "$main" "$pictures/still.png"
}

looks=${LOOKS:-"light-en-1 dark-en-1 light-en-2 dark-en-2 light-cs-1 dark-cs-1 light-cs-2 dark-cs-2"}
for each in $looks; do
    # shellcheck disable=SC2046
    look $(echo "$each" | tr - ' ')
done

if [ "$docs" = yes ]; then
    convert "$pictures/still.png" -quality 88 docs/images/window.jpg
    convert "$pictures/jobs-light-en-1.png" -quality 88 docs/images/jobs.jpg
    convert "$pictures/settings-light-en-1.png" -quality 88 docs/images/settings.jpg
    convert -gravity NorthEast \( "$pictures/lights-light-en-1.png" -crop 335x586+0+54 +repage \) \
        \( "$pictures/bookmarks-light-en-1.png" -crop 279x586+0+54 +repage \) +append +dither -colors 192 docs/images/panels.png
    for each in start share export recording statistics configure1 render-more; do
        convert "$pictures/$each-light-en-1.png" +dither -colors 128 "docs/images/$each.png"
    done
fi
echo "The pictures are in $pictures"
