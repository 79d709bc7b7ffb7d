#!/bin/sh
# All set-up, then all tests: the release build with everything; unit and mutation tests under the address and
# undefined-behaviour sanitizers, those of the libraries or those of the programs by turns (RT_TURN, see
# build_sanitized.sh; check-long.sh sanitizers: all of them), those of shared memory under the thread sanitizer, too.
# RT_TEST_SCENES may name a folder with real models for more tests. Says how long each stage took, and how many processor
# seconds: what is compiled beside the tests counts where it is waited for; what servers that tests detach take counts
# nowhere.
#   scripts/test.sh [--without-nets]
# The weights of nets that denoise are brought, too, beside the build: where npm is installed, it is an error when they do
# not come. --without-nets leaves them out.
set -eu
nets=yes
case ${1:-} in
    '') ;;
    --without-nets) nets=no ;;
    *) echo "usage: test.sh [--without-nets]" >&2; exit 2 ;;
esac
cd "$(dirname "$0")/.."
jobs=$(nproc)
# Threads that wait for others sleep: tests run side by side, and would spend a third of the processor time on waiting.
export OMP_WAIT_POLICY=passive
# What is checked with sanitizers takes turns: the second of the commit says, which a shallow clone knows, too.
RT_TURN=${RT_TURN:-$(git log -1 --format=%ct 2>/dev/null || echo 0)}
export RT_TURN
begun=$(date +%s)
mkdir -p build

# Sets `spent` to the processor seconds of all processes so far that have ended. Not in a subshell, which has its own.
count_seconds() {
    times >build/times.txt
    spent=$(LC_ALL=C awk 'NR == 2 { split($0, t, "[ms ]+"); printf "%.0f", 60 * (t[1] + t[3]) + t[2] + t[4] }' build/times.txt)
}
# Time since $1, and processor seconds beyond $2, as "stage: 2:05 minutes, 130 processor seconds".
tell() {
    taken=$(($(date +%s) - $1))
    count_seconds
    printf '== %s: %d:%02d minutes, %d processor seconds\n' "$3" $((taken / 60)) $((taken % 60)) $((spent - $2))
}
# Runs the function $2 and tells how long it took.
stage() {
    from=$(date +%s)
    count_seconds
    before=$spent
    $2
    tell "$from" "$before" "$1"
}

install() {
    scripts/setup.sh --tests
    [ "$nets" = yes ] || return 0
    setsid scripts/fetch-nets.sh &
    fetching=$!
    trap 'kill -s TERM -- "-$fetching" 2>/dev/null || true' EXIT
    trap 'exit 130' INT TERM
}
build() {
    # Warnings are errors, and tests are compiled in larger parts, except in what was built without: that is not built again.
    [ -f build/release/CMakeCache.txt ] || export RT_WERROR=ON RT_TESTS_TOGETHER=24
    scripts/build.sh --tests
}
# Without npm (69) the script has said how to get them.
await_nets() {
    code=0
    wait "$fetching" || code=$?
    trap - EXIT
    [ $code -eq 0 ] || [ $code -eq 69 ] || exit $code
}
# Unit tests and those of the window as whole programs, since ctest begins a process for each of 2,700 tests.
check_programs() {
    {
        [ ! -x build/release/bin/test_gui ] || printf 'build/release/bin/test_gui:%s\n' 0/2 1/2
        for folder in tests/unit/*/; do
            program=build/release/bin/test_$(basename "$folder")
            [ ! -x "$program" ] || echo "$program"
        done
    } | xargs -n 1 -P "$jobs" scripts/run_tests.sh
}
# Tests wait for much: what the next stage needs is compiled meanwhile, in the processor time that they leave.
check_release() {
    # In a session of its own, which ends as a whole. Where the kernel shares time out among sessions (autogroup), how nice
    # a process is counts within its session alone: the session is told, too, or tests would have half of the processor.
    setsid sh -c '(echo 19 >/proc/self/autogroup) 2>/dev/null || true
        exec nice -n 19 scripts/build_sanitized.sh' >build/sanitized.log 2>&1 &
    builder=$!
    trap 'kill -s TERM -- -$builder 2>/dev/null || true' EXIT
    trap 'exit 130' INT TERM
    scripts/check-style.sh
    check_programs
    # The last ones have checks of their own in check-long.sh.
    RT_LEAVING_RAYS=${RT_LEAVING_RAYS:-500000} ctest --preset release -j "$jobs" \
        -LE '^(unit|unit[.]quick|gui|web|strangers|walks)$'
}
await_sanitized() {
    wait $builder || {
        cat build/sanitized.log
        exit 1
    }
    trap - EXIT
}
# Whole programs: with sanitizers a process takes long to begin, and ctest begins one for each test. Of the longest ones a
# quarter is run; check-long.sh runs all of them.
check_sanitized() {
    export RT_QUARTER="test_accel test_import test_kernels test_live test_neural test_render test_rtserver"
    export RT_QUARTER_FROM=$((RT_TURN / 2 % 4))
    export UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=allocator_may_return_null=1
    find build/asan-ubsan/bin -name 'test_*' -print0 | xargs -0 -n 1 -P "$jobs" scripts/run_tests.sh
}
# Shared memory is where programs meet without a lock.
check_threads() {
    build/tsan/bin/test_ipc --gtest_brief=1
}

stage "installing" install
stage "building" build
[ "$nets" = no ] || stage "waiting for nets" await_nets
stage "tests" check_release
stage "building with sanitizers" await_sanitized
stage "tests with sanitizers" check_sanitized
stage "tests of threads" check_threads
tell "$begun" 0 "all"
