#!/usr/bin/env bash
# Renders the gallery, docs/gallery: a counterpart of every figure of the thesis that this project grew from, and what only
# path tracing shows.
#   scripts/gallery.sh [--quick] [--output FOLDER] [NAME...]
#   scripts/gallery.sh --list | --commands
# NAME: the number of a figure (8.6), more or paths, the name of a picture (cube-bloom), or the beginning of one (cube); all without it.
# --quick: a quarter of the size, one sample per pixel or eight paths, into output/gallery unless told where.
# --list: figures and pictures. --commands: the Renderer's command for each.
# RT_BIN names a folder of programs to be used as they are; without it scripts/build.sh is run first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# figure, picture, models of data/gallery that it needs (- for none), what the Renderer is told
pictures=$(grep -v '^#' data/gallery/pictures.txt)

usage() {
    echo "usage: gallery.sh [--quick] [--output FOLDER] [NAME...] | --list | --commands" >&2
    exit 2
}
quick=0 folder="" names=()
while (($#)); do
    case $1 in
        --quick) quick=1 ;;
        --output) (($# > 1)) || usage; folder=$2; shift ;;
        --output=*) folder=${1#*=} ;;
        --list) awk '{print $1, $2}' <<<"$pictures"; exit 0 ;;
        --commands) awk '{name = $2; $1 = $2 = $3 = ""; print "Renderer" substr($0, 3) " -o " name ".jpg"}' <<<"$pictures"; exit 0 ;;
        -*) usage ;;
        *) names+=("$1") ;;
    esac
    shift
done

# The lines of the pictures that were asked for.
chosen=$pictures
if ((${#names[@]})); then
    chosen=""
    for name in "${names[@]}"; do
        found=$(awk -v name="$name" '($1 "") == (name "") || index($2, name) == 1' <<<"$pictures")
        [[ -n $found ]] || { echo "gallery: there is no picture '$name'; --list names them" >&2; exit 2; }
        chosen+=$found$'\n'
    done
    chosen=$(sed '/^$/d' <<<"$chosen" | awk '!seen[$2]++')
fi

if [[ -z $folder ]]; then ((quick)) && folder=output/gallery || folder=docs/gallery; fi
if [[ -z ${RT_BIN:-} ]]; then
    scripts/build.sh --programs
    RT_BIN=build/release/bin
fi
mkdir -p "$folder"
models=$(awk '$3 != "-" {print $3}' <<<"$chosen" | tr ',' '\n' | sort -u)
# shellcheck disable=SC2086
[[ -z $models ]] || PYTHONDONTWRITEBYTECODE=1 python3 data/gallery/make_gallery.py $models

part=$folder/.rendering-$$.jpg
trap 'rm -f "$part"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
count=$(wc -l <<<"$chosen") number=0 began=$SECONDS
while read -r figure name _ arguments; do
    number=$((number + 1)) started=$SECONDS
    echo "[$number/$count] $figure $name ..."
    read -ra words <<<"$arguments"
    if ((quick)); then
        words+=(--setting width=240 --setting height=135 --setting antialiasing=1)
        [[ $arguments != *--integrator=path* ]] || words+=(--setting path.samples=8)
    fi
    "$RT_BIN/Renderer" "${words[@]}" -o "$part" --progress=none </dev/null
    mv -f "$part" "$folder/$name.jpg"
    echo "        $folder/$name.jpg: $((SECONDS - started)) s"
done <<<"$chosen"
echo "gallery: $count pictures in $((SECONDS - began)) s"
