#!/usr/bin/env bash
# Installs the packages of packages.txt that are missing: `tools/install_packages.sh GROUP...` (build, test, fuzz, oracle).
# Does nothing, and needs neither root nor a network, when all are there.
set -euo pipefail

if [ $# -eq 0 ]; then
  echo "usage: $0 GROUP..." >&2
  exit 2
fi
list=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/packages.txt
wanted=$(awk -v groups=" $* " '{sub(/#.*/, "")} NF >= 2 && index(groups, " " $2 " ") {print $1}' "$list")

missing=()
for package in $wanted; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "These packages are missing, and neither root nor sudo is there to install them:" >&2
    echo "  ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "Installing ${#missing[@]} packages: ${missing[*]}"

log=$(mktemp)
trap 'rm -f "$log"' EXIT
install() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y --no-install-recommends "${missing[@]}" </dev/null >"$log" 2>&1
}
# The package index is refreshed only when the one that is there will not do.
if ! install && ! { "${as_root[@]}" apt-get update </dev/null >"$log" 2>&1 && install; }; then
  tail -n 5 "$log" >&2
  echo "The packages cannot be installed. Without a network? Install them yourself and try again:" >&2
  echo "  apt-get install ${missing[*]}" >&2
  exit 1
fi
