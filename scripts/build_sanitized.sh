#!/bin/sh
# Builds those tests that test.sh runs under the address and undefined-behaviour sanitizers, into build/asan-ubsan, and
# under the thread sanitizer, into build/tsan. Those of arithmetic on numbers and scenes of their own, which no input of
# a user's reaches but through other tests, are left to check-long.sh; so are the checks that take as long to compile as
# all else: of pointers (null, alignment, vptr), which the address sanitizer stops at where they matter, and of sizes of
# objects, which it knows better.
#   RT_TURN: a number. With an even one those of the libraries are built alone, with an odd one those of the programs, whose
# sources are a third of all that there is to compile; without it, both.
set -eu
cd "$(dirname "$0")/.."
options="-DRT_WERROR=ON -DRT_EVERY_INSTRUCTION_SET=OFF -DRT_TESTS_TOGETHER=24"
# shellcheck disable=SC2086
cmake --preset asan-ubsan $options -DRT_SANITIZE_WITHOUT=null,alignment,vptr,object-size >/dev/null
targets=""
for folder in tests/unit/*/; do
    name=$(basename "$folder")
    case $name in
    accel_validation | gathering | lights | look | math | motion | pathtracing | post | rtbench | sampling | scattering | settings) ;;
    shading | simd | sky | steady_frame) ;;
    apps | bridge | cui | processes | rtserver)
        [ $((${RT_TURN:-1} % 2)) -eq 0 ] || targets="$targets --target test_$name"
        ;;
    *) [ $((${RT_TURN:-0} % 2)) -eq 1 ] || targets="$targets --target test_$name" ;;
    esac
done
rm -f build/asan-ubsan/bin/test_* # those of another turn may be older than the sources
# shellcheck disable=SC2086
cmake --build --preset asan-ubsan $targets
# shellcheck disable=SC2086
cmake --preset tsan $options >/dev/null
cmake --build --preset tsan --target test_ipc
