#!/bin/sh
# Installs what is missing and builds everything, optimised, into build/release (programs in build/release/bin).
#   scripts/build.sh [--no-apt]     RT_WERROR=ON makes warnings errors
set -eu
cd "$(dirname "$0")/.."
scripts/setup.sh "$@"
cmake --preset release -DRT_WERROR="${RT_WERROR:-OFF}" >build-configure.log 2>&1 || {
    cat build-configure.log >&2
    exit 1
}
mv build-configure.log build/release/configure.log
cmake --build --preset release
scripts/make_data.sh
echo "build: programs are in build/release/bin"
