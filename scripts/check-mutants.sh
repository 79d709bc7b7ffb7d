#!/bin/sh
# Breaks the protocol between the programs, one rule at a time, and looks whether the tests notice. The rules stand in
# the code where they are kept (libs/ipc/platform/rules.h). A mutant that survives is an error: a rule that no test
# guards.
#   scripts/check-mutants.sh [rule...]     without rules: all; with --list: their names
set -eu
cd "$(dirname "$0")/.."
rules() { grep -rhoE 'keeps\("[^"]+"\)' libs/ipc | sed 's/keeps("\(.*\)")/\1/' | sort; }
if [ "${1-}" = --list ]; then
    rules
    exit
fi
if [ -n "$(rules | uniq -d)" ]; then
    echo "check-mutants: a rule stands twice: $(rules | uniq -d | head -n 1)" >&2
    exit 1
fi
for wanted in "$@"; do
    rules | grep -qxF -e "$wanted" && continue
    echo "check-mutants: no rule is called '$wanted'; --list names them" >&2
    exit 2
done
work=$(mktemp -d "${TMPDIR:-/tmp}/rtsuite-mutants-XXXXXX")
chmod 755 "$work"
export RT_TEST_INSTANCE="m$$-" TMPDIR="$work/tmp"
mkdir "$TMPDIR"
chmod 755 "$TMPDIR"
trap 'rm -rf "$work" /dev/shm/rts.*.m$$-*' EXIT
trap 'exit 130' INT TERM

# Prints the test that fails, or that hangs, first; nothing when all pass.
caught() {
    for program in test_ipc "test_ipc_process --gtest_filter=-Killed.ServersAndClients"; do
        code=0
        # shellcheck disable=SC2086
        timeout -k 5 90 "$work"/build/bin/$program --gtest_fail_fast >"$work/run.log" 2>&1 || code=$?
        [ $code -eq 0 ] && continue
        failed=$(sed -n 's/^\[  FAILED  \] \([^ ,]*\).*/\1/p' "$work/run.log" | head -n 1)
        [ -n "$failed" ] || failed="$(sed -n 's/^\[ RUN *\] //p' "$work/run.log" | tail -n 1) (ended with $code)"
        echo "$failed"
        return
    done
}

echo "check-mutants: building"
cmake --preset headless -B "$work/build" -DCMAKE_CXX_FLAGS=-DRT_IPC_RULES >/dev/null
cmake --build "$work/build" --target test_ipc test_ipc_process -- -j "${RT_JOBS:-$(nproc)}" >"$work/build.log" 2>&1 || {
    tail -n 20 "$work/build.log"
    exit 1
}
survivor=$(caught)
if [ -n "$survivor" ]; then
    echo "check-mutants: $survivor fails with every rule kept" >&2
    exit 1
fi
survived=0
if [ $# -gt 0 ]; then printf '%s\n' "$@"; else rules; fi >"$work/rules.txt"
while read -r rule; do
    test=$(RT_BROKEN_RULE="$rule" caught)
    echo "not: $rule: ${test:-SURVIVED}"
    [ -n "$test" ] || survived=$((survived + 1))
done <"$work/rules.txt"
[ $survived -eq 0 ] || exit 1
echo "check-mutants: every broken rule is noticed"
