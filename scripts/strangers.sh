#!/bin/sh
# Shows how models that nobody prepared are seen first: a sheet of their first views.
#   scripts/strangers.sh FOLDER [MODEL...]     without models: those of tests/strangers, which it makes there
# Writes FOLDER/NAME.png, what the Renderer said as FOLDER/NAME.txt, and FOLDER/sheet.png (ImageMagick).
set -eu
[ $# -gt 0 ] || {
    sed -n '2,4s/^# \{0,1\}//p' "$0" >&2
    exit 2
}
here=$(cd "$(dirname "$0")/.." && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift
[ $# -gt 0 ] || {
    python3 "$here/tests/strangers/make_strangers.py" "$folder/models"
    set -- "$folder"/models/*.obj "$folder"/models/*.stl "$folder"/models/*.glb
}
for model in "$@"; do
    name=$(basename "$model")
    timeout 120 "$here/build/release/bin/Renderer" -v "$model" -o "$folder/$name.png" -w 480 -h 300 \
        >"$folder/$name.txt" 2>&1 || echo "strangers: no image of $name: see $folder/$name.txt" >&2
done
command -v montage >/dev/null || {
    echo "strangers: no sheet: montage is missing (ImageMagick)" >&2
    exit 0
}
cd "$folder"
montage -label '%t' ./*.*.png -tile 6x -geometry 240x150+2+2 sheet.png
echo "$folder/sheet.png"
