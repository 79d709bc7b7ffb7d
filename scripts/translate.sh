#!/bin/sh
# Brings the translations of the window's texts up to date: new texts come in as unfinished, those that are gone go out.
# Unfinished texts are then to be translated (a test refuses them), by Qt Linguist or in an editor.
#   scripts/translate.sh [--check]      --check: change nothing; say what is missing, and fail if anything is
set -eu
cd "$(dirname "$0")/.."
file=apps/gui/translations/gui_cs.ts
lupdate=$(command -v lupdate || echo /usr/lib/qt6/bin/lupdate)
[ -x "$lupdate" ] || {
    echo "translate: lupdate is missing (qt6-l10n-tools)" >&2
    exit 77
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$file" "$work/gui_cs.ts"
"$lupdate" -silent apps/gui -I apps -extensions cpp,h -locations none -no-obsolete -tr-function-alias QT_TR_NOOP+=TEXT \
    -source-language en -target-language cs -ts "$work/gui_cs.ts"
if [ "${1:-}" != --check ]; then
    cp "$work/gui_cs.ts" "$file"
    echo "translate: $(grep -c 'type="unfinished"' "$file" || true) texts are to be translated in $file"
    exit 0
fi
if grep -B 3 'type="unfinished"' "$work/gui_cs.ts"; then
    echo "translate: these texts are not translated; run scripts/translate.sh, then translate them in $file" >&2
    exit 1
fi
