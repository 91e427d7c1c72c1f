#!/usr/bin/env bash
# Runs every group of `inhabit bench`, as its help lists them, one after the other: `tools/benches.sh INHABIT DIR`. Each group's
# tables go to DIR/NAME.txt, its plots beside them. `--list` instead of DIR prints the groups. A group that fails is named and
# does not keep the others from running; the exit code is 1 then. Groups that need the data folder are skipped without one.
set -euo pipefail

if [ $# -ne 2 ]; then
  echo "usage: $0 INHABIT DIR|--list" >&2
  exit 2
fi
inhabit=$1 out=$2
# Lines of the help between "Groups:" and the next that is not indented; "layout" stands for several of the others.
rows=$("$inhabit" bench --help | sed -n '/^Groups:/,/^[^ ]/{/^  /p}' | grep -v '^  layout ' || true)
if [ -z "$rows" ]; then
  echo "$0: the help of $inhabit bench lists no groups" >&2
  exit 1
fi
if [ "$out" = --list ]; then
  awk '{print $1}' <<<"$rows"
  exit 0
fi

mkdir -p "$out"
failed=()
while read -r group sentence; do
  if [[ $sentence == *"needs the data folder"* ]] && [ ! -d "${INHABIT_DATA:-}" ]; then
    echo "$group: skipped, the variable INHABIT_DATA names no data folder"
    continue
  fi
  begin=$SECONDS
  if "$inhabit" bench "$group" --quiet --plots "$out" >"$out/$group.txt" 2>"$out/$group.err" </dev/null; then
    rm "$out/$group.err"
    echo "$group: $((SECONDS - begin)) s, $out/$group.txt"
  else
    failed+=("$group")
    echo "$group: failed after $((SECONDS - begin)) s" && tail -n 5 "$out/$group.err"
  fi
done <<<"$rows"
if [ ${#failed[@]} -gt 0 ]; then
  echo "$0: failed: ${failed[*]}" >&2
  exit 1
fi
