#!/usr/bin/env bash
# Draws the documentation's pictures of people anew, after a build: `tools/make_crowd_pictures.sh`.
# The figures beside them are `inhabit bench emergence`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

inhabit=build/release/inhabit
walks=out/walks
mkdir -p "$walks" docs/pictures
walk() { # NAME SCENE SECONDS [options of simulate]
  local name=$1 scene=$2 seconds=$3
  shift 3
  "$inhabit" simulate "$scene" --seconds "$seconds" --every 12 -q -o "$walks/$name.h5" "$@"
}
draw() { # NAME [options of render]
  local name=$1
  shift
  "$inhabit" render "$walks/$name.h5" -o "docs/pictures/$name.png" -q --pixels 800 "$@"
}
walk lanes dense-passing 27
draw lanes --paths --color way --from 19 --until 26
walk thick-lanes dense-passing 34 --far avoidance --set cohesion=0.05
draw thick-lanes --paths --color way --from 24 --until 32
walk jam bottleneck-3600 60
draw jam --at 60 --radius 0.5 --trail 0
walk ellipse dense-ellipsoid 85
draw ellipse --at 82 --radius 0.5 --trail 0 --color way
walk rabbits bears-and-rabbits 41
draw rabbits --paths --color way --from 15 --until 40
walk power-law power-law-dense 36
draw power-law --at 35 --radius 1 --trail 0
# A film, and three of its pictures side by side.
if command -v ffmpeg >/dev/null; then
  "$inhabit" simulate bottleneck-480 --seconds 30 -q -o "$walks/film.h5"
  "$inhabit" render "$walks/film.h5" -o "$walks/film.mp4" -q --radius 0.5 --width 640 --speed 2
  ffmpeg -loglevel error -y -i "$walks/film.mp4" -vf "select='not(mod(n,115))',tile=3x1" -frames:v 1 docs/pictures/film.png
fi
