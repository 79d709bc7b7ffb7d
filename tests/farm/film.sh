# Sourced by the tests: a film of a small scene. Sets `work` (removed at the end), `renderer`, `farm`, and `frames`.
renderer=$1
farm=$2/scripts/farm.sh
frames=24
work=$(mktemp -d)

# Writes film.lst and its cameras.
write_film() {
    number=0 # recorded exposures are scaled by the first frame, whoever renders which
    while [ "$number" -lt "$frames" ]; do
        printf 'version = 1\neye = [0.%02d, 1.7, 3.0]\nforward = [0.0, 0.0, -1.0]\nexposure = 0.5\n' "$number" >"$work/$number.cam"
        echo "$number.cam" >>"$work/film.lst"
        number=$((number + 1))
    done
}
wrong() {
    printf 'wrong: %s\n' "$1" >&2
    exit 1
}
# All frames are there, whole, and the same as without a farm.
check_frames() {
    "$renderer" "$scene" -l "$work/film.lst" -o "$work/out/####.png" --verify || wrong "frames are missing"
    # shellcheck disable=SC2086
    "$renderer" "$scene" -l "$work/film.lst" -o "$work/alone/####.png" $quality --frames 2-7 || wrong "no frames alone"
    for frame in 0002 0007; do
        cmp "$work/out/$frame.png" "$work/alone/$frame.png" || wrong "frame $frame differs"
    done
}
