#!/usr/bin/env bash
# The main job on real input: takes two rooms of one of Sweet Home 3D's example homes, furnishes them afresh and writes the
# home back: `tools/furnish_example.sh INHABIT HOMES OUT`. HOMES is what tools/fetch_sweethome3d.sh fills; without it the
# exit code is 77. OUT gets every file at the end, so that none is ever half-written.
set -euo pipefail

if [ $# -ne 3 ]; then
  echo "usage: $0 INHABIT HOMES OUT" >&2
  exit 2
fi
inhabit=$1 home=$2/examples/3BedroomHouseWithAttic.xml out=$3
rooms=("Living Room" "Bedroom #1")
afresh=(--start placed --house-rules --starts 30 --seed 1)

if [ ! -f "$home" ]; then
  echo "skipped: no example homes; tools/fetch_sweethome3d.sh build/sweethome3d fetches them"
  exit 77
fi
mkdir -p "$out"
work=$(mktemp -d "$out/.work.XXXXXX")
trap 'rm -rf "$work"' EXIT

# Warnings about what the whole home has outside of rooms are kept for when something fails.
quietly() {
  if ! "$@" 2>"$work/messages"; then
    cat "$work/messages" >&2
    echo "failed: $*" >&2
    return 1
  fi
}
# "Bedroom #1" gives bedroom-1.
file_name() { sed 's/[^a-z0-9]\+/-/g; s/-$//' <<<"${1,,}"; }

quietly "$inhabit" furnish "$home" --room "${rooms[0]}" --room "${rooms[1]}" "${afresh[@]}" -q -o "$work/home-furnished.sh3d"
for room in "${rooms[@]}"; do
  name=$(file_name "$room")
  quietly "$inhabit" convert "$home" "$work/$name-before.json" --room "$room"
  quietly "$inhabit" furnish "$home" --room "$room" "${afresh[@]}" -o "$work/$name-after.json"
  for when in before after; do
    for extension in svg png; do
      quietly "$inhabit" render "$work/$name-$when.json" -o "$work/$name-$when.$extension"
    done
  done
  echo
done
# What was written into the home is what was furnished.
for room in "${rooms[@]}"; do
  quietly "$inhabit" check "$work/home-furnished.sh3d" --room "$room" -q
done
mv -f "$work"/*.{json,svg,png,sh3d} "$out/"
