#!/bin/sh
# Renders a list of cameras on many machines that share a folder: as an array of Slurm jobs, or by GNU parallel on this
# machine and on others by ssh. At the end all frames are verified, and the film is made if one is wanted. Frames that
# are there already are not rendered again: to go on after a failure, submit once more.
#   scripts/farm.sh SCENE LIST -o out/####.png [OPTION]... [-- RENDERER-OPTION...]
set -eu

usage() {
    cat <<'TEXT'
usage: farm.sh SCENE LIST -o out/####.png [OPTION]... [-- RENDERER-OPTION...]

Renders the frames of LIST (.cam files, one a line) in parts, on many machines that share a folder; then verifies
them all. Frames that are there already are not rendered again.

  -o, --output=PATTERN      where frames go; #### becomes the number of the frame
      --video=FILE          make a film of the frames at the end (.mp4, .webm, .mkv, .gif; needs ffmpeg)
      --integrator=NAME     whitted or path; as --samples=N and what follows --, for the Renderer
      --samples=N           paths per pixel
      --engine=ENGINE       slurm or parallel [slurm where there is sbatch, else parallel]
      --parts=N             parts that the list is cut into [one for 8 frames, at most 500]
      --retries=N           how often a part is tried again that was stopped or lost its machine [5]
      --log=FOLDER          where each part writes what it says [the folder of the frames, farm-log]
      --renderer=FILE       the Renderer [the one of this build, else the one in PATH]
      --sbatch=OPTION       slurm: handed to sbatch, as in --sbatch=--partition=render; may be given several times
      --wait                slurm: show the progress and wait for the end
      --hosts=LIST          parallel: machines for ssh, as in a,b,: - the last is this machine; each renders a part at a time
  -h, --help                show this help

Exit codes: 0 done, or submitted; 1 frames are missing; 2 wrong usage; 66 no such file; 69 no such engine.
TEXT
}
tell() { printf 'farm: %s\n' "$1"; }
fail() { # CODE MESSAGE
    tell "$2" >&2
    exit "$1"
}
# shellcheck source=scripts/names.sh
. "$(dirname "$0")/names.sh"
# Passes numbers that the shell's arithmetic takes: no leading zero, nothing that overflows.
check_number() { # OPTION VALUE LEAST
    case $2 in
        '' | *[!0-9]* | 0?* | ??????????*) ;;
        *) if [ "$2" -ge "$3" ]; then return; fi ;;
    esac
    fail 2 "$1=$2: give a whole number from $3 to 999999999"
}

scene="" list="" output="" video="" engine="" parts=own retries=5 log="" renderer="" hosts="" wait=no
sbatch_options="" renderer_options=""
[ $# -gt 0 ] || { usage >&2; exit 2; }
while [ $# -gt 0 ]; do
    case $1 in
        --*=*) value=${1#*=} ;;
        *) value="" ;;
    esac
    case $1 in
        -h | --help) usage; exit 0 ;;
        -o | --output) [ $# -gt 1 ] || fail 2 "$1 needs a value"; output=$2; shift ;;
        --output=*) output=$value ;;
        --video=*) video=$value ;;
        --integrator=* | --samples=*) renderer_options="$renderer_options $(quoted "$1")" ;;
        --engine=*) engine=$value ;;
        --parts=*) parts=$value ;;
        --retries=*) retries=$value ;;
        --log=*) log=$value ;;
        --renderer=*) renderer=$value ;;
        --sbatch=*) sbatch_options="$sbatch_options $(quoted "$value")" ;;
        --hosts=*) hosts=$value ;;
        --wait) wait=yes ;;
        --) shift; for option in "$@"; do renderer_options="$renderer_options $(quoted "$option")"; done; break ;;
        -*) fail 2 "$1: there is no such option; farm.sh --help lists them" ;;
        *) if [ -z "$scene" ]; then scene=$1; elif [ -z "$list" ]; then list=$1; else fail 2 "$1: too many files"; fi ;;
    esac
    shift
done

[ -n "$list" ] || fail 2 "give a scene and a list of .cam files"
[ -n "$output" ] || fail 2 "say where the frames go: -o out/####.png"
case ${output##*/} in *'#'*) ;; *) fail 2 "$output: the name needs #### for the number of the frame" ;; esac
check_number --retries "$retries" 0
[ "$parts" = own ] || check_number --parts "$parts" 1
for file in "$scene" "$list"; do [ -f "$file" ] || fail 66 "$file: there is no such file"; done
if [ -z "$renderer" ]; then
    renderer=$(cd "$(dirname "$0")/.." && pwd)/build/release/bin/Renderer
    [ -x "$renderer" ] || renderer=$(command -v Renderer) || fail 66 "there is no Renderer; build it, or name it by --renderer"
fi
[ -x "$renderer" ] || fail 66 "$renderer: there is no such program"
if [ -z "$engine" ]; then
    engine=parallel
    if command -v sbatch >/dev/null 2>&1; then engine=slurm; fi
fi
case $engine in
    slurm) command -v sbatch >/dev/null 2>&1 || fail 69 "there is no sbatch; install slurm-client, or use --engine=parallel" ;;
    parallel) command -v parallel >/dev/null 2>&1 || fail 69 "there is no GNU parallel; install the package parallel" ;;
    *) fail 2 "$engine: the engines are slurm and parallel" ;;
esac

for name in scene list output renderer; do absolute $name; done
[ -z "$video" ] || absolute video
frames=$(LC_ALL=C grep -cv '^[[:space:]]*\(#.*\)\{0,1\}$' "$list") || fail 65 "$list: it names no .cam file"
if [ "$parts" = own ]; then
    parts=$(((frames + 7) / 8))
    [ "$parts" -le 500 ] || parts=500
fi
[ "$parts" -le "$frames" ] || parts=$frames
folder=${output%/*}/
log=${log:-${folder}farm-log}
absolute log
mkdir -p "$folder" "$log"

frames_of="$(quoted "$renderer") $(quoted "$scene") -l $(quoted "$list") -o $(quoted "$output")"
# Parts learn indirect light, if frames are lit by it, once, and not each that of the whole list.
light=$log/film.light
case "$renderer_options" in *--light*) light="" ;; *) rm -f "$light" ;; esac
render="$frames_of$renderer_options${light:+ --light=$(quoted "$light")} --progress=plain"
verify="$frames_of --verify"
# Where options of the Renderer name files, they do so from here.
here="cd $(quoted "$PWD") 2>/dev/null"
finish="$here; $verify"
# The film takes the frames as they are.
[ -z "$video" ] || finish="$finish && $render --video=$(quoted "$video")"

# Whether frame files are missing, by what --verify says.
missing() { sh -c "$verify" 2>/dev/null | wc -l; }

# To parallel a name in the command, or in --results, is a template, of which {= =} is a program: none stands there. The
# part is a script in the folder of the log, where parallel is started and, by --workdir, what it starts on other machines.
# There, parallel takes $SHELL for the shell, which services and containers may not have: it is told one.
by_parallel() {
    printf '%s\n' "$here; $render --chunk=\$1/$parts --requeue" >"$log/part.sh"
    [ -z "$hosts" ] || set -- "$@" -S "$hosts" --workdir=.
    [ ! -t 2 ] || set -- "$@" --bar
    # A part that was stopped (75) or failed is tried again; one that was rendered yesterday is quickly skipped.
    (
        cd "$log"
        rm -f journal
        seq "$parts" | PARALLEL_SHELL=/bin/sh parallel "$@" --will-cite --jobs 1 --retries "$((retries + 1))" --joblog journal \
            --results part-{} sh part.sh {} >/dev/null || true
    )
    sh -c "$finish" || fail 1 "frames are missing; $log tells why; go on by the same command"
    tell "$frames frames are there: $output"
}

# A part that was stopped (75) goes back into the queue: by the cluster itself where it is set up so (RequeueExit), else
# by its own request.
part_script() {
    cat <<TEXT
#!/bin/sh
exec >>$(quoted "$log")/part-\$SLURM_ARRAY_TASK_ID.log 2>&1
$here
trap 'kill -TERM \$child 2>/dev/null' TERM INT
$render --chunk=\$SLURM_ARRAY_TASK_ID/$parts --requeue --threads=\${SLURM_CPUS_ON_NODE:-0} &
child=\$!
while true; do
    code=0
    wait \$child || code=\$?
    kill -0 \$child 2>/dev/null || break
done
# Stopped before it could say so.
[ \$code != 143 ] || code=75
[ \$code -lt 128 ] || echo "ended by signal \$((code - 128))"
if [ \$code = 75 ]; then
    if [ "\${SLURM_RESTART_COUNT:-0}" -ge $retries ]; then exit 1; fi
    if ! scontrol show config | grep -q '^RequeueExit *=.*\b75\b'; then
        scontrol requeue "\${SLURM_ARRAY_JOB_ID}_\$SLURM_ARRAY_TASK_ID" && exit 0
    fi
fi
exit \$code
TEXT
}

# To sbatch the name of a log is a pattern, too, which not every name can be written as: a job opens its own.
by_slurm() {
    name=$(printf %s "${list##*/}" | tr -c '[:alnum:]._-' _)
    eval "set -- --parsable --chdir=/ --output=/dev/null$sbatch_options"
    array=$(part_script | sbatch --requeue --open-mode=append --job-name="render $name" --array="1-$parts" \
        "$@" | cut -d ';' -f 1)
    [ -n "$array" ] || fail 1 "sbatch did not take the parts"
    end=$(printf '#!/bin/sh\nexec >%s 2>&1\n%s\n' "$(quoted "$log/finish.log")" "$finish" |
        sbatch --job-name="finish $name" --dependency="afterany:$array" "$@" | cut -d ';' -f 1)
    [ -n "$end" ] || fail 1 "sbatch did not take the end; scancel $array ends the parts"
    tell "$frames frames in $parts parts: job $array; then $end verifies them; $log has what they say"
    [ "$wait" = yes ] || return 0
    while squeue --noheader --job="$end" 2>/dev/null | grep -q .; do
        left=$(missing)
        tell "$((frames - left)) of $frames frames"
        sleep 2
    done
    [ "$(missing)" = 0 ] || fail 1 "frames are missing; $log tells why; go on by the same command"
    if [ -n "$video" ] && [ ! -s "$video" ]; then fail 1 "there is no film; $log/finish.log tells why"; fi
    tell "$frames frames are there: $output"
}

"by_$engine"
