#!/bin/sh
# Installs the packages of packages.txt that are missing. Never removes one. Of cimg-dev only the header is taken, with
# its licence, into build/cimg: none of its dependencies (OpenCV and VTK, 1.3 GB) is used.
#   scripts/setup.sh [--no-apt] [--tests] [--peers] [--services] [--cad] [--nets]
# --no-apt: only say what is missing, and fail if anything is. --tests, --peers, --services, --cad: those of
# packages-tests.txt and so on, too. Installed services are not started. --nets: the weights of the nets that denoise,
# too, by fetch-nets.sh beside this script; where it fails, its exit code is returned.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cimg=$here/../build/cimg
apt=yes more="" nets=no
for option in "$@"; do
    case $option in
        --no-apt) apt=no ;;
        --tests | --peers | --services | --cad) more="$more $here/packages-${option#--}.txt" ;;
        --nets) nets=yes ;;
        *)
            echo "usage: setup.sh [--no-apt] [--tests] [--peers] [--services] [--cad] [--nets]" >&2
            exit 2 ;;
    esac
done
[ "$nets" = no ] || "$here/fetch-nets.sh"

installed() {
    [ "$(dpkg-query -W -f '${db:Status-Abbrev}' "$1" 2>/dev/null | cut -c1-2)" = "ii" ]
}
has() {
    installed "$1" || { [ "$1" = cimg-dev ] && [ -f "$cimg/CImg.h" ]; }
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
# shellcheck disable=SC2086
lines=$(cat "$here/packages.txt" $more)
while IFS= read -r line; do
    alternatives=$(echo "${line%%#*}" | tr -d ' ')
    [ -n "$alternatives" ] || continue
    served=no
    for package in $(echo "$alternatives" | tr '|' ' '); do
        if has "$package"; then served=yes; fi
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

# Leaves the header there only when it is whole.
unpack_cimg() {
    work=$(mktemp -d)
    (cd "$work" && apt-get -q -o APT::Sandbox::User=root download cimg-dev && dpkg-deb -x cimg-dev_*.deb .) &&
        mkdir -p "$cimg" &&
        cp "$work/usr/share/doc/cimg-dev/copyright" "$cimg/copyright" &&
        cp "$work/usr/include/CImg.h" "$cimg/CImg.h.new" &&
        mv "$cimg/CImg.h.new" "$cimg/CImg.h" || { rm -rf "$work"; return 1; }
    rm -rf "$work"
}
# Needs no root where it is known what packages there are.
if [ "$missing" = " cimg-dev" ] && unpack_cimg; then exit 0; fi

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
    chosen=${chosen:-${alternatives%%|*}}
    [ "$chosen" = cimg-dev ] || names="$names $chosen"
done

has cimg-dev || unpack_cimg
[ -n "$names" ] || exit 0

# Debian's packages ask this program before they start a service.
policy=/usr/sbin/policy-rc.d
if [ ! -e $policy ]; then
    trap '$root rm -f $policy' EXIT
    trap 'exit 130' INT TERM
    printf '#!/bin/sh\nexit 101\n' | $root tee $policy >/dev/null
    $root chmod 755 $policy
fi
# --no-remove: a machine with other versions keeps them, and this fails with a reason instead.
# shellcheck disable=SC2086
$root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 install -y -q --no-remove --no-install-recommends $names
case " $names " in
*" nginx-light "*)
    # Nor at the next start of the machine.
    if command -v systemctl >/dev/null 2>&1; then $root systemctl disable -q nginx || true; fi
    ;;
esac
