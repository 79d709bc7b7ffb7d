#!/bin/sh
# Runs all tests of one program, and prints what it says only when one fails.
#   scripts/run_tests.sh PROGRAM
set -u
begun=$(date +%s)
if output=$("$1" --gtest_brief=1 2>&1); then
    echo "passed in $(($(date +%s) - begun)) s: $1"
else
    printf '%s\nFAILED: %s\n' "$output" "$1"
    exit 1
fi
