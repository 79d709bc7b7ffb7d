#!/bin/sh
# Runs the tests of one program, and prints what they say only when one fails.
#   scripts/run_tests.sh PROGRAM[:SHARD/SHARDS]     such a part of them, from 0
# RT_QUARTER: names of programs with blanks between, of which each fourth test is run, from the one that RT_QUARTER_FROM
# (0 to 3) says.
set -u
begun=$(date +%s)
program=${1%%:*}
case $1 in
*:*)
    part=${1#*:}
    export GTEST_TOTAL_SHARDS="${part#*/}" GTEST_SHARD_INDEX="${part%/*}"
    ;;
esac
case " ${RT_QUARTER:-} " in
*" $(basename "$program") "*) export GTEST_TOTAL_SHARDS=4 GTEST_SHARD_INDEX="${RT_QUARTER_FROM:-0}" ;;
esac
if output=$("$program" --gtest_brief=1 2>&1); then
    clock=$(mktemp)
    times >"$clock" # not in a subshell, which has its own
    spent=$(LC_ALL=C awk 'NR == 2 { split($0, t, "[ms ]+"); printf "%.1f", 60 * (t[1] + t[3]) + t[2] + t[4] }' "$clock")
    rm -f "$clock"
    echo "passed in $(($(date +%s) - begun)) s, $spent processor seconds: $1"
else
    printf '%s\nFAILED: %s\n' "$output" "$1"
    exit 1
fi
