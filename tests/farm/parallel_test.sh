#!/bin/sh
# scripts/farm.sh with GNU parallel: a broken camera fails the film, all others are rendered; mended, it goes on.
set -eu
command -v parallel >/dev/null 2>&1 || {
    echo "skipped: GNU parallel is not installed"
    exit 77
}
# shellcheck source=tests/farm/film.sh
. "$(dirname "$0")/film.sh"
trap 'rm -rf "$work"' EXIT
scene=$2/data/tiny/tiny.scn
quality="-w 32 -h 24 --integrator=path --samples=2"
write_film
mkdir "$work/alone"
submit() {
    # shellcheck disable=SC2086
    "$farm" "$scene" "$work/film.lst" -o "$work/out/####.png" --engine=parallel --parts=5 --retries=1 \
        --renderer="$renderer" -- $quality
}
mv "$work/7.cam" "$work/lost.cam"
submit && wrong "a missing camera was not noticed"
[ "$(find "$work/out" -name '*.png' | wc -l)" = $((frames - 1)) ] || wrong "the other frames are not there"
mv "$work/lost.cam" "$work/7.cam"
submit || wrong "the film cannot be completed"
check_frames
"$farm" "$scene" "$work/film.lst" -o "$work/out/one.png" 2>/dev/null && wrong "a name without a number was taken"
for number in 0 -1 1.5 08 x '' 2147483648 99999999999999999999 18446744073709551617; do
    code=0
    "$farm" "$scene" "$work/film.lst" -o "$work/out/####.png" --engine=parallel --parts="$number" 2>"$work/said" || code=$?
    [ "$code" = 2 ] && [ "$(wc -l <"$work/said")" = 1 ] && grep -q '^farm: --parts=' "$work/said" ||
        wrong "--parts=$number is answered by $(cat "$work/said")"
done
echo "all frames by GNU parallel"
