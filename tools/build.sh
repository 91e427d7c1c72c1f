#!/usr/bin/env bash
# Configures a preset of CMakePresets.json and builds targets of it, all when none is named: `tools/build.sh PRESET [TARGET...]`.
# Says one line when it goes well and shows what the compiler said when it does not.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [ $# -eq 0 ]; then
  echo "usage: $0 PRESET [TARGET...]" >&2
  exit 2
fi
preset=$1
shift
targets=()
[ $# -eq 0 ] || targets=(--target "$@")

mkdir -p build
log=build/$preset.log
begin=$SECONDS
if [ ! -f "build/$preset/build.ninja" ]; then
  echo "Building $preset: minutes the first time, seconds from then on"
  if ! cmake --preset "$preset" >"$log" 2>&1; then
    cat "$log" >&2
    exit 1
  fi
fi
# On a terminal ninja counts on one line.
if [ -t 1 ]; then
  cmake --build --preset "$preset" "${targets[@]}"
elif ! cmake --build --preset "$preset" "${targets[@]}" >"$log" 2>&1; then
  grep -v '^\[[0-9]*/[0-9]*\] \(Building\|Linking\)' "$log" | tail -n 60 >&2
  exit 1
fi
echo "Built $preset in $((SECONDS - begin)) s"
