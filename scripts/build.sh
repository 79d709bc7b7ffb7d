#!/bin/sh
# Installs what is missing and builds everything, optimised, into build/release (programs in build/release/bin).
#   scripts/build.sh [--no-apt] [--programs | --tests]     --programs: no tests; --tests: no benchmarks but rtbench
# In the environment: RT_WERROR=ON makes warnings errors (unset: as in build/release, so that nothing is built again),
# RT_WITH_GUI=OFF leaves the window out, RT_TESTS_TOGETHER=24 compiles more sources of tests as one (unset: as before).
set -eu
cd "$(dirname "$0")/.."
target="all benches"
apt=""
for option in "$@"; do
    case $option in
        --no-apt) apt=--no-apt ;;
        --programs) target=programs ;;
        --tests) target=all ;;
        *) echo "usage: build.sh [--no-apt] [--programs | --tests]" >&2; exit 2 ;;
    esac
done
scripts/setup.sh $apt
cmake --preset release ${RT_WERROR:+"-DRT_WERROR=$RT_WERROR"} \
    ${RT_TESTS_TOGETHER:+"-DRT_TESTS_TOGETHER=$RT_TESTS_TOGETHER"} -DRT_WITH_GUI="${RT_WITH_GUI:-AUTO}" >build-configure.log 2>&1 || {
    cat build-configure.log >&2
    exit 1
}
mv build-configure.log build/release/configure.log
# shellcheck disable=SC2086
cmake --build --preset release --target $target
scripts/make_data.sh
echo "build: programs are in build/release/bin"
