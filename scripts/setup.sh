#!/bin/sh
# Installs the packages of packages.txt that are missing. Never removes one.
#   scripts/setup.sh [--no-apt]     --no-apt: only say what is missing, and fail if anything is
set -eu
here=$(cd "$(dirname "$0")" && pwd)

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

missing=""
updated=no
while IFS= read -r line; do
    line=${line%%#*}
    first=$(echo "$line" | cut -d'|' -f1 | tr -d ' ')
    second=$(echo "$line" | cut -s -d'|' -f2 | tr -d ' ')
    [ -n "$first" ] || continue
    installed "$first" && continue
    [ -n "$second" ] && installed "$second" && continue
    missing="$missing $first${second:+|$second}"
done <"$here/packages.txt"
[ -n "$missing" ] || exit 0

if [ "${1:-}" = "--no-apt" ]; then
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
export DEBIAN_FRONTEND=noninteractive
echo "setup: installing$missing"
$root apt-get -o DPkg::Lock::Timeout=300 update -q
names=""
for entry in $missing; do
    first=${entry%%|*}
    second=$(echo "$entry" | cut -s -d'|' -f2)
    if available "$first" || [ -z "$second" ]; then names="$names $first"; else names="$names $second"; fi
done
# --no-remove: a machine with other versions keeps them, and this fails with a reason instead.
# shellcheck disable=SC2086
$root apt-get -o DPkg::Lock::Timeout=300 install -y -q --no-remove --no-install-recommends $names
