#!/bin/sh
# Makes the .deb of build/release under a strict umask, unpacks it into a folder of its own, and tries each program from
# there, as a user without rights.
#   scripts/check-package.sh [--chroot]
# --chroot: installs it in a clean Debian 12 as well (root, debootstrap, the network; three to four minutes).
set -eu
cd "$(dirname "$0")/.."
chroot=no
case "${1:-}" in
    "") ;;
    --chroot) chroot=yes ;;
    *) echo "usage: check-package.sh [--chroot]" >&2; exit 2 ;;
esac
say() { echo "check-package: $*"; }
fail() {
    say "$*" >&2
    exit 1
}

work=$(mktemp -d)
mounted=""
# Nothing that is still mounted may be removed with the folder.
clean() {
    for place in $mounted; do umount "$place" || exit 1; done
    rm -rf "$work"
}
trap clean EXIT
trap 'exit 130' INT TERM HUP

cmake --build build/release --target programs >"$work/build.log" 2>&1 || {
    tail -n 20 "$work/build.log" >&2
    fail "the programs cannot be built"
}
(umask 077 && cd build/release && cpack -G DEB -B "$work/package") >"$work/cpack.log" 2>&1 || {
    cat "$work/cpack.log" >&2
    fail "cpack failed"
}
package=$(ls "$work"/package/*.deb)
say "$(basename "$package"), $(wc -c <"$package") bytes"
depends=$(dpkg-deb -f "$package" Depends)
for library in libc6 libassimp libfmt libpng libboost-program-options; do
    case $depends in *"$library"*) ;; *) fail "it does not depend on $library: $depends" ;; esac
done
for needless in embree gtest libmpi; do
    case $depends in *"$needless"*) fail "it depends on $needless" ;; esac
done
for field in Maintainer Section Description Recommends Suggests; do
    [ -n "$(dpkg-deb -f "$package" $field)" ] || fail "the field $field is empty"
done

if dpkg-deb -c "$package" | grep -q '[.]tza$'; then fail "it contains weights of nets"; fi
dpkg-deb -c "$package" | grep -q '/bin/rtsuite-fetch-nets$' || fail "it does not contain what brings nets"

closed=$(dpkg-deb -c "$package" | grep -v '^\(drwxr-xr-x\|-rwxr-xr-x\|-rw-r--r--\|lrwxrwxrwx\) root/root ' || true)
[ -z "$closed" ] || fail "not for everybody to read:
$closed"

# Tries the programs of a prefix: try PREFIX, as they run in a folder of their own.
cat >"$work/try.sh" <<'EOF'
set -eu
prefix=$1
cd "$2"
bin=$prefix/bin
programs="Renderer RTServer BSPBuilder CUI"
for name in RTBridge GUI; do
    [ ! -x "$bin/$name" ] || programs="$programs $name"
done
for name in $programs; do
    QT_QPA_PLATFORM=offscreen "$bin/$name" --version >version.txt
    QT_QPA_PLATFORM=offscreen "$bin/$name" --help >help.txt
    test -f "$prefix/share/man/man1/$name.1.gz"
    test -f "$prefix/share/bash-completion/completions/$name"
done
scenes=$prefix/share/rtsuite/scenes
"$bin/BSPBuilder" "$scenes/mirrors/generated/mirrors.glb" mirrors.bsp -f --progress=none
"$bin/Renderer" "$scenes/mirrors/mirrors.scn" --model mirrors.bsp -o still.png -w 64 -h 36 -a 1 --progress=none
export XDG_RUNTIME_DIR=$2
instance=package-$$
"$bin/RTServer" "$scenes/mirrors/mirrors.scn" --instance=$instance --resolution=64x36 --daemon
"$bin/CUI" --instance=$instance wait-idle
"$bin/CUI" --instance=$instance screenshot live.png
"$bin/CUI" --instance=$instance render rendered.png
if [ -x "$bin/RTBridge" ]; then
    # The links of both, and not a word more, before it is ended.
    code=0
    timeout --preserve-status -s TERM 5 "$bin/RTBridge" --instance=$instance --listen=unix >links.txt || code=$?
    test $code -eq 143
    test "$(grep -c '#t=' links.txt)" -eq 2
fi
"$bin/CUI" --instance=$instance exit
cmp live.png rendered.png
test -s still.png
if [ -x "$bin/GUI" ]; then
    test -f "$prefix/share/applications/rtsuite.desktop"
    code=0
    HOME=$2 QT_QPA_PLATFORM=offscreen timeout --preserve-status -s TERM 5 \
        "$bin/GUI" mirrors.bsp --instance=$instance 2>gui.txt || code=$?
    test $code -eq 143
    "$bin/CUI" list >list.txt
    ! grep -q $instance list.txt
fi
EOF

mkdir "$work/root"
mkdir -m 700 "$work/run"
dpkg-deb -x "$package" "$work/root"
desktop=$work/root/usr/share/applications/rtsuite.desktop
if [ -f "$desktop" ] && command -v desktop-file-validate >/dev/null 2>&1; then desktop-file-validate "$desktop"; fi
as_user=""
if [ "$(id -u)" -eq 0 ]; then
    chmod 755 "$work"
    chown nobody "$work/run"
    as_user="setpriv --reuid=nobody --regid=nogroup --clear-groups env HOME=$work/run"
fi
# shellcheck disable=SC2086
$as_user sh "$work/try.sh" "$work/root/usr" "$work/run" || fail "a program of the unpacked package failed"
say "every program works from the unpacked package"

if command -v lintian >/dev/null 2>&1; then
    lintian --fail-on error "$package"
else
    say "skipped lintian: it is not installed"
fi

[ "$chroot" = yes ] || exit 0
[ "$(id -u)" -eq 0 ] || fail "--chroot needs root"
command -v debootstrap >/dev/null 2>&1 || fail "--chroot needs debootstrap"
began=$(date +%s)
clean=$work/clean
debootstrap --variant=minbase bookworm "$clean" >"$work/debootstrap.log" 2>&1 || {
    tail -n 5 "$work/debootstrap.log" >&2
    fail "debootstrap failed"
}
say "a clean Debian 12 in $(($(date +%s) - began)) s"
began=$(date +%s)
cp "$package" "$clean/tmp/rtsuite.deb"
cp "$work/try.sh" "$clean/tmp/try.sh"
mkdir -m 700 "$clean/tmp/run"
mount -t proc proc "$clean/proc"
mounted="$clean/proc"
mount -t tmpfs tmpfs "$clean/dev/shm"
mounted="$clean/dev/shm $mounted"
DEBIAN_FRONTEND=noninteractive LC_ALL=C chroot "$clean" \
    apt-get install -y -q --no-install-recommends /tmp/rtsuite.deb >"$work/install.log" 2>&1 || {
    tail -n 5 "$work/install.log" >&2
    fail "the package cannot be installed"
}
say "installed there in $(($(date +%s) - began)) s, with $(grep -c '^Setting up' "$work/install.log") packages"
chroot "$clean" sh /tmp/try.sh /usr /tmp/run || fail "a program failed in the clean system"
LC_ALL=C chroot "$clean" dpkg --audit
say "every program works in the clean system"
