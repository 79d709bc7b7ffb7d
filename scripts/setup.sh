#!/bin/sh
# Installs the packages of packages.txt that are missing. Never removes one.
#   scripts/setup.sh [--no-apt] [--peers]
# --no-apt: only say what is missing, and fail if anything is. --peers: those of packages-peers.txt, too.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
apt=yes peers=""
for option in "$@"; do
    case $option in
        --no-apt) apt=no ;;
        --peers) peers=$here/packages-peers.txt ;;
        *)
            echo "usage: setup.sh [--no-apt] [--peers]" >&2
            exit 2 ;;
    esac
done

installed() {
    [ "$(dpkg-query -W -f '${db:Status-Abbrev}' "$1" 2>/dev/null | cut -c1-2)" = "ii" ]
}
available() {
    [ -n "$(apt-cache policy "$1" 2>/dev/null | sed -n 's/ *Candidate: \(.*\)/\1/p' | grep -v '(none)')" ]
}

if ! command -v dpkg-query >/dev/null 2>&1; then
    echo "setup: this is no Debian; install the libraries that scripts/packages.txt names, then build with cmake" >&2
    exit 0
fi

# One entry a line that is not served: its alternatives, joined by "|".
missing=""
lines=$(cat "$here/packages.txt" ${peers:+"$peers"})
while IFS= read -r line; do
    alternatives=$(echo "${line%%#*}" | tr -d ' ')
    [ -n "$alternatives" ] || continue
    served=no
    for package in $(echo "$alternatives" | tr '|' ' '); do
        if installed "$package"; then served=yes; fi
    done
    [ "$served" = yes ] || missing="$missing $alternatives"
done <<TEXT
$lines
TEXT
[ -n "$missing" ] || exit 0

if [ "$apt" = no ]; then
    echo "setup: missing packages:$missing" >&2
    exit 1
fi

root=""
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null 2>&1 || {
        echo "setup: missing packages:$missing; install them as root (there is no sudo here)" >&2
        exit 1
    }
    root="sudo"
fi
echo "setup: installing$missing"
$root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 update -q
names=""
for alternatives in $missing; do
    chosen=""
    for package in $(echo "$alternatives" | tr '|' ' '); do
        # Boost 1.81 would take the place of an installed 1.74.
        case $package in *1.81*) if installed libboost1.74-dev; then continue; fi ;; esac
        if [ -z "$chosen" ] && available "$package"; then chosen=$package; fi
    done
    names="$names ${chosen:-${alternatives%%|*}}"
done
# --no-remove: a machine with other versions keeps them, and this fails with a reason instead.
# shellcheck disable=SC2086
$root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 install -y -q --no-remove --no-install-recommends $names
