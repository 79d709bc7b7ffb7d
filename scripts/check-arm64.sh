#!/bin/sh
# Builds for arm64 by Debian's cross compiler, in a Debian of its own beside this one, and runs there by qemu: tests, and
# Renderer, whose images must have the bits of those by build/release. Says "skipped" where it cannot run.
#   scripts/check-arm64.sh [tests] [images]     without arguments: both
# Needs root, scripts/build.sh before it and, for the first time, the network. In the environment: RT_ARM64_DEBIAN, where
# that Debian is kept (1.5 GB) [build/arm64-debian]; RT_DEBIAN_MIRROR, where its packages come from
# [http://deb.debian.org/debian]; RT_ARM64_TESTS, the test programs without "test_".
set -eu
cd "$(dirname "$0")/.."
say() { echo "check-arm64: $*"; }
fail() {
    say "$*" >&2
    exit 1
}
skip() {
    say "skipped: $*"
    exit 0
}
[ $# -gt 0 ] || set -- tests images
for part in "$@"; do
    case $part in
    tests | images) ;;
    *) echo "usage: check-arm64.sh [tests] [images]" >&2; exit 2 ;;
    esac
done

# Mounts made in here are seen by this script and its children alone, and are gone with them, however they end.
if [ "${RT_ARM64_MOUNTS:-}" != own ]; then
    [ "$(dpkg --print-architecture 2>/dev/null)" = amd64 ] || skip "this is no Debian for amd64"
    [ "$(id -u)" -eq 0 ] || skip "a Debian beside this one needs root"
    unshare --mount true 2>/dev/null || skip "nothing may be mounted here"
    RT_ARM64_MOUNTS=own exec unshare --mount "$0" "$@"
fi

programs=build/release/bin
[ -x $programs/Renderer ] && [ -x $programs/BSPBuilder ] && [ -x $programs/rtimport ] ||
    fail "$programs lacks programs; build them first (scripts/build.sh)"
place=${RT_ARM64_DEBIAN:-build/arm64-debian}
mkdir -p "$place"
place=$(cd "$place" && pwd)
debian=$place/root
built=build/arm64
jobs=$(nproc)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM HUP

# The libraries of packages.txt, and GoogleTest; not those of the window, of rare images, and of CImg, whose one header
# depends on half of a desktop.
wanted() {
    echo "build-essential crossbuild-essential-arm64 cmake ninja-build pkg-config python3-minimal qemu-user-static"
    sed '1,/^# libraries/d; /^#/,$d; s/ .*//' scripts/packages.txt | grep -vE '^(qt6|cimg|libmagick)' |
        sed 's/$/:arm64/; s/^nlohmann-json3-dev.*/nlohmann-json3-dev/'
    echo "libgtest-dev:arm64"
}

# From the network, but not installed here.
fetch_mmdebstrap() {
    if command -v mmdebstrap >/dev/null 2>&1; then
        ln -s "$(command -v mmdebstrap)" "$work/mmdebstrap"
        return
    fi
    (cd "$work" && apt-get -o APT::Sandbox::User=root download mmdebstrap) >"$work/fetch.log" 2>&1 || {
        tail -n 3 "$work/fetch.log"
        skip "mmdebstrap is not installed, and cannot be fetched"
    }
    dpkg -x "$work"/mmdebstrap_*.deb "$work/unpacked"
    ln -s "$work/unpacked/usr/bin/mmdebstrap" "$work/mmdebstrap"
}

# Is there from the time before, or is made: whole, or not at all.
make_debian() {
    if [ -f "$debian/wanted" ] && [ "$(cat "$debian/wanted")" = "$(wanted)" ]; then return; fi
    mirror=${RT_DEBIAN_MIRROR:-http://deb.debian.org/debian}
    fetch_mmdebstrap
    say "making a Debian in $debian (a minute or more)"
    rm -rf --one-file-system "$debian" "$debian.new"
    # shellcheck disable=SC2016
    "$work/mmdebstrap" --mode=root --variant=apt --architectures=amd64,arm64 --aptopt='APT::Install-Recommends "false"' \
        --include="$(wanted | tr '\n' ' ')" \
        --customize-hook='chroot "$1" sh -c "cd /tmp && apt-get download cimg-dev && dpkg -x cimg-dev_*.deb / && rm cimg-dev_*"' \
        bookworm "$debian.new" "deb $mirror bookworm main" >"$work/debian.log" 2>&1 || {
        tail -n 5 "$work/debian.log"
        rm -rf --one-file-system "$debian.new"
        grep -qE 'Could not (resolve|connect)|Connection|Temporary failure' "$work/debian.log" &&
            skip "the network does not serve $mirror"
        fail "no Debian can be made in $debian"
    }
    wanted >"$debian.new/wanted"
    mv "$debian.new" "$debian"
}

# This folder, and what programs need of a system, at the same paths in there.
mount_all() {
    mkdir -p "$debian$PWD"
    mount --bind "$PWD" "$debian$PWD"
    mount --rbind /dev "$debian/dev"
    mount -t proc proc "$debian/proc"
    mount -t tmpfs tmpfs "$debian/tmp"
}

# inside COMMAND...: in that Debian, in this folder.
inside() {
    chroot "$debian" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp LC_ALL=C.UTF-8 \
        sh -c 'cd "$1"; shift; exec "$@"' sh "$PWD" "$@"
}
by_qemu() { inside qemu-aarch64-static "$@"; }

tests=${RT_ARM64_TESTS:-"simd kernels trees image accel accel_validation math sampling scene settings shading neural pathtracing irradiance gathering render post live
motion import images bsp text debug platform"}

build() {
    begun=$(date +%s)
    say "building in $built"
    targets="Renderer BSPBuilder rtimport"
    for test in $tests; do targets="$targets test_$test"; done
    # shellcheck disable=SC2086
    inside cmake --preset arm64 -DRT_WERROR=ON >"$work/build.log" 2>&1 &&
        inside cmake --build --preset arm64 --target $targets -- -j "$jobs" >>"$work/build.log" 2>&1 || {
        grep -A 10 'error' "$work/build.log" | head -n 50 | grep . || tail -n 20 "$work/build.log"
        fail "it cannot be built"
    }
    say "built in $(($(date +%s) - begun)) s"
}

# Programs start the importer without qemu: a script stands in its place.
wrap_importer() {
    touch "$debian/rtimport"
    mount --bind $built/bin/rtimport "$debian/rtimport"
    printf '#!/bin/sh\nexec qemu-aarch64-static /rtimport "$@"\n' >"$debian/tmp/rtimport"
    chmod 755 "$debian/tmp/rtimport"
    mount --bind "$debian/tmp/rtimport" "$debian$PWD/$built/bin/rtimport"
}

run_tests() {
    for test in $tests; do
        begun=$(date +%s)
        by_qemu $built/bin/test_"$test" --gtest_brief=1 >"$work/test.log" 2>&1 || {
            cat "$work/test.log"
            fail "test_$test fails on arm64"
        }
        say "test_$test passes in $(($(date +%s) - begun)) s"
    done
}

# same NAME SCENE OPTION...: the images of both, as they are shown and before tone mapping.
same() {
    name=$1
    shift
    begun=$(date +%s)
    set -- "$@" -w 128 -h 96 -a 2 --setting=sampling=rotated --progress=none
    for kind in png pfm; do
        $programs/Renderer "$@" -o "$work/$name.$kind" || fail "x86's Renderer fails with $name"
        by_qemu $built/bin/Renderer "$@" -o "/tmp/$name.$kind" || fail "arm64's Renderer fails with $name"
        cmp "$work/$name.$kind" "$debian/tmp/$name.$kind" || fail "$name.$kind has other bits on arm64"
    done
    say "$name has the same bits, in $(($(date +%s) - begun)) s"
}

compare_images() {
    scripts/make_data.sh
    $programs/BSPBuilder data/mirrors/generated/mirrors.glb "$work/mirrors.bsp" --progress=none
    by_qemu $built/bin/BSPBuilder data/mirrors/generated/mirrors.glb /tmp/mirrors.bsp --progress=none
    cmp "$work/mirrors.bsp" "$debian/tmp/mirrors.bsp" || fail "BSPBuilder writes other bytes on arm64"
    same shafts data/gallery/shafts.scn --setting=fog.shafts=8 --setting=exposure.local=0.5 --setting=denoise.passes=2 -b 3
    same mist data/gallery/mist.scn -aon 8 --setting=depthOfField.on=true --setting=depthOfField.focus=5 \
        --setting=toneMapping=channels
    same paths data/mirrors/mirrors.scn --integrator=path --samples=2 --setting=path.filter=0
    if [ -f build/nets/rt_hdr_calb_cnrm.tza ]; then
        same net data/mirrors/mirrors.scn --integrator=path --samples=2 --denoise=base
        same mixed data/mirrors/mirrors.scn --integrator=path --samples=16 --denoise=small
    else
        say "there are no weights in build/nets: without images by nets"
    fi
    same mirrors data/mirrors/mirrors.scn --setting=adaptive=0.05 -b 2 --setting=bloom.kernel=airy
}

make_debian
mount_all
build
wrap_importer
for part in "$@"; do
    case $part in
    tests) run_tests ;;
    images) compare_images ;;
    esac
done
