#!/bin/sh
# All set-up, then all tests: the release build with everything, the libraries' unit and mutation tests under the
# address and undefined-behaviour sanitizers. RT_TEST_SCENES may name a folder with real models for more tests.
set -eu
cd "$(dirname "$0")/.."
RT_WERROR=ON scripts/build.sh
scripts/check-style.sh
jobs=$(nproc)
ctest --preset release -j "$jobs"

cmake --preset asan-ubsan -DRT_WERROR=ON >/dev/null
cmake --build --preset asan-ubsan --target unit_tests
UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=allocator_may_return_null=1 \
    ctest --preset asan-ubsan -j "$jobs" -L unit
