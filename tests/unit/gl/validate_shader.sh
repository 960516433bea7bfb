#!/bin/sh
# validate_shader.sh EXPAND VALIDATOR SHADER: compiles a shader with the reference compiler, once for each set of defines
# named in its "// variants:" line (sets separated by ";"), or once without any.
set -eu
text=$("$1" "$3")
variants=$(printf '%s\n' "$text" | sed -n 's|^// variants: *||p' | head -1)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
IFS=';'
for set in ${variants:-none}; do
  IFS=' '
  [ "$set" = none ] && set=
  # shellcheck disable=SC2086 # one argument a define
  "$1" "$3" $set >"$folder/shader.comp"
  "$2" -S comp "$folder/shader.comp" || exit 1
  IFS=';'
done
