#!/usr/bin/env bash
# Brings translations/*.ts up to date with the texts in the window's sources and those that the library marks with VS_TEXT; new ones are marked unfinished until somebody
# translates them (doc/translating.md). `tools/update_translations.sh FILE.ts` updates another file: a copy, for tests.
set -euo pipefail
ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
for lupdate in /usr/lib/qt6/bin/lupdate lupdate6 lupdate; do
  command -v "$lupdate" >/dev/null && break
done
CASES=$(mktemp --suffix=.cpp) # the texts of cases stand in files of their own
trap 'rm -f "$CASES"' EXIT
python3 "$ROOT/tools/case_texts.py" "$ROOT" > "$CASES"
cd "$ROOT/apps/desktop"
"$lupdate" -silent -no-obsolete -locations none -source-language en -target-language de \
  -tr-function-alias QT_TRANSLATE_NOOP+=VS_TEXT . "$ROOT/src" "$CASES" -ts "${1:-$ROOT/translations/volume-studio_de.ts}" \
  2> >(grep -v "lacks Q_OBJECT macro" >&2)
