#!/bin/sh
# scripts/farm.sh with names that are programs or patterns to somebody: nothing of them runs, and all frames are there.
#   names_test.sh RENDERER SOURCES ENGINE [apart]
# Each name is that of the scene, of the list and of the output: of three runs at once, or, `apart`, in runs of their own.
# slurm is a script here, which does what sbatch does with its options: slurm_test.sh has a real one.
set -eu
# shellcheck source=tests/farm/film.sh
. "$(dirname "$0")/film.sh"
trap 'rm -rf "$work"' EXIT
source=$2/data/tiny engine=$3 how=${4:-together}
HOME=$work/home # where a job by ssh would run
mkdir "$HOME"
export HOME
if [ "$engine" = slurm ]; then
    ln -s "$(realpath "$(dirname "$0")/sbatch.sh")" "$work/sbatch"
    PATH=$work:$PATH
else
    command -v parallel >/dev/null 2>&1 || {
        echo "skipped: GNU parallel is not installed"
        exit 77
    }
fi
line_end='
'
count=0
# COMMAND with each name; a file RAN... comes of one that is run.
each_name() {
    for name in 'x{= `touch RAN` =}' 'x{= system("touch RAN") =}' '{= $_="; touch RAN;" =}' '{}' '{#}' '{%}' '{.}{1}' \
        '{+.}{= "' "it's" 'say "RAN"' '$(touch RAN)' '`touch RAN`' 'a; touch RAN' 'a & touch RAN' '| touch RAN' \
        "a${line_end}touch RAN$line_end" '~' '*' '#' '%a %j %%' 'x\ty \c \n\' '-x' 'K'"$(printf '\303\244')"'se' \
        '  two  blanks  ' "$line_end#SBATCH --wrap=touch RAN"; do
        "$@" "$name"
    done
}
# submit SCENE LIST OUTPUT: the names in a folder of their own, which has the plain one, too.
submit() {
    count=$((count + 1))
    folder=$work/$count
    mkdir "$folder"
    cp "$source/tiny.obj" "$source/tiny.mtl" "$folder"
    cp "$source/tiny.scn" "$folder/$1.scn"
    cp "$work/0.cam" "$folder"
    echo 0.cam >"$folder/$2.lst"
    cd "$folder"
    "$farm" "./$1.scn" "./$2.lst" -o "$3/$3####.png" --engine="$engine" ${hosts:+"--hosts=$hosts"} --retries=0 \
        --renderer="$renderer" -- -w 4 -h 3 >"$work/said" 2>&1 || wrong "farm.sh fails with $1, $2, $3: $(cat "$work/said")"
    cd "$work"
    for frame in "$folder/$3/"*1.png; do [ -s "$frame" ] || wrong "no frame with $1, $2, $3"; done
    [ -f "$folder/$3/farm-log/part-1" ] || [ -f "$folder/$3/farm-log/part-1.log" ] || wrong "no log with $1, $2, $3"
    [ -z "$(find "$work" -name 'RAN*')" ] || wrong "a name of $1, $2, $3 ran"
}
in_turn() {
    submit "$1" plain out
    submit plain "$1" out
    submit plain plain "$1"
}
before='' last=''
at_once() {
    submit "$1" "${before:-$1}" "${last:-$1}"
    last=$before
    before=$1
}
# On another machine, which is a shell in the home folder, and tells nobody which.
by_ssh() {
    cat >"$work/ssh" <<'TEXT'
#!/bin/sh
while [ "${1#-}" != "$1" ]; do shift; done
shift
[ "$1" != -- ] || shift
cd "$HOME"
exec sh -c "$*"
TEXT
    chmod 755 "$work/ssh"
    hosts=1/other
    name="{= \`touch RAN\` =} \$(touch RAN) %a \\t @{[\`touch RAN\`]} ' \" {} {.}$line_end"
    export PARALLEL_SSH="$work/ssh"
    unset SHELL
    submit "$name" "$name" "$name"
    unset PARALLEL_SSH
    hosts=''
}

frames=1 hosts=''
write_film
[ "$engine" = slurm ] || by_ssh
if [ "$how" = apart ]; then each_name in_turn; else each_name at_once; fi
echo "$count runs by $engine, and nothing of a name ran"
