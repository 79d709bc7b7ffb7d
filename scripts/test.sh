#!/bin/sh
# All set-up, then all tests: the release build with everything, the libraries' unit and mutation tests under the
# address and undefined-behaviour sanitizers, those of shared memory under the thread sanitizer, too. RT_TEST_SCENES
# may name a folder with real models for more tests.
set -eu
cd "$(dirname "$0")/.."
# Warnings are errors, except in what was built without: that is not built again.
[ -f build/release/CMakeCache.txt ] || export RT_WERROR=ON
scripts/build.sh
scripts/check-style.sh
jobs=$(nproc)
ctest --preset release -j "$jobs"

cmake --preset asan-ubsan -DRT_WERROR=ON >/dev/null
cmake --build --preset asan-ubsan --target unit_tests
UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=allocator_may_return_null=1 \
    ctest --preset asan-ubsan -j "$jobs" -L unit

# Shared memory is where programs meet without a lock.
cmake --preset tsan -DRT_WERROR=ON >/dev/null
cmake --build --preset tsan --target test_ipc
build/tsan/bin/test_ipc --gtest_brief=1
