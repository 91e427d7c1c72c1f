#!/usr/bin/env bash
# Draws the pictures of the documentation anew, after ./quickstart: `tools/make_pictures.sh`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

inhabit=build/release/inhabit
mkdir -p docs/pictures
tools/furnish_example.sh "$inhabit" build/sweethome3d out/quickstart >/dev/null
for when in before after; do
  "$inhabit" render "out/quickstart/living-room-$when.json" -o "docs/pictures/living-room-$when.png" --pixels 720
done
"$inhabit" furnish tight-bedroom --variants 6 -q --png out/tight-bedroom.png
cp out/tight-bedroom.png docs/pictures/tight-bedroom.png

"$inhabit" learn build/sweethome3d/examples/*.xml -q -o out/homes.priors.json --explain out/priors/
cp out/priors/kind-chair.png docs/pictures/priors-kind.png
cp out/priors/pair-table-chair.png docs/pictures/priors-pair.png

"$inhabit" render exemplar/flower-shop -o docs/pictures/exemplar-flower-shop.png --pixels 1200

tools/make_crowd_pictures.sh
