#!/bin/sh
# The layout of the code by clang-format 14, the words of docs/style.md, the pages' columns and links, the rooms that may
# call the system, what the window shows as plain text, the translated sentences, the files that the bridge opens, the rules of mutants and the
# syntax of the scripts; with --tidy also clang-tidy over the release build (takes a while).
#   scripts/check-style.sh [--tidy]
set -eu
cd "$(dirname "$0")/.."
if clang-format --version 2>/dev/null | grep -q "version 14\."; then
    git ls-files '*.cpp' '*.h' | xargs clang-format --dry-run -Werror
    echo "check-style: clang-format is content"
else
    echo "check-style: skipped clang-format: version 14 is not installed" >&2
fi
scripts/check_words.py
echo "check-style: the words are those of docs/style.md"
scripts/check_documents.py
echo "check-style: the pages and the page's modules are wrapped, links lead somewhere and images are shown"
scripts/check_system_headers.py
echo "check-style: system headers are included in their rooms only"
scripts/check_plain_text.py
echo "check-style: the window takes no text for markup"
scripts/sentences.py --check
echo "check-style: what the server and the bridge say is said in forms, which are translated"
if git grep -nE '\b[io]?fstream\b|\b(fopen|open|read[A-Za-z]*(File|Text)|write[A-Za-z]*File|use_[a-z_]*file)\(' -- \
    'apps/bridge/*.cpp' 'apps/bridge/*.h' | grep -vE '^apps/bridge/(tokens|net/tls|net/own_certificate)\.cpp:|acceptor\.open\('; then
    echo "check-style: the bridge opens no file but those of its tokens and its certificate" >&2
    exit 1
fi
echo "check-style: the bridge opens its tokens and certificate only"
# A rule that moved or was renamed would else be missed when the mutants are made, in hours.
scripts/check_kernel_mutants.py --check
scripts/check_bridge_mutants.py --check
echo "check-style: the rules that mutants break stand in the sources"
# Each by the shell that its first line names.
git ls-files '*.sh' .ci/run | while read -r script; do
    shell=$(sed -n '1s/^#![^ ]*[/ ]\([a-z]*\)$/\1/p' "$script")
    "${shell:-sh}" -n "$script" || exit 1
done
echo "check-style: the scripts' syntax is right"
[ "${1:-}" = "--tidy" ] || exit 0
git ls-files '*.cpp' | xargs -n 4 -P "$(nproc)" clang-tidy -p build/release --quiet --extra-arg=-Wno-unknown-warning-option
echo "check-style: clang-tidy is content"
