#!/bin/sh
# validate_shader.sh EXPAND VALIDATOR SPIRV_VAL SHADER: compiles a shader with the reference compiler into SPIR-V for OpenGL,
# which spirv-val then checks, once for each set of defines named in its "// variants:" line (sets separated by ";"), or
# once without any.
set -eu
text=$("$1" "$4")
variants=$(printf '%s\n' "$text" | sed -n 's|^// variants: *||p' | head -1)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
IFS=';'
for set in ${variants:-none}; do
  IFS=' '
  [ "$set" = none ] && set=
  # shellcheck disable=SC2086 # one argument a define
  "$1" "$4" $set >"$folder/shader.comp"
  "$2" -S comp "$folder/shader.comp" || exit 1
  # SPIR-V wants a location for each uniform, which OpenGL chooses itself for GLSL.
  "$2" -G --auto-map-locations --auto-map-bindings -S comp -o "$folder/shader.spv" "$folder/shader.comp" >"$folder/log" ||
    { cat "$folder/log"; exit 1; }
  "$3" --target-env opengl4.5 "$folder/shader.spv" || exit 1
  IFS=';'
done
