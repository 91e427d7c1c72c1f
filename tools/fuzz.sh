#!/usr/bin/env bash
# Runs one fuzz target for so many seconds: `tools/fuzz.sh BUILD NAME [SECONDS]`. What breaks it lies in BUILD/crashes/.
# Exit code 77 when the target is not built: it needs clang.
set -euo pipefail

if [ $# -lt 2 ]; then
  echo "usage: $0 BUILD NAME [SECONDS]" >&2
  exit 2
fi
build=$1 name=$2 seconds=${3:-${INHABIT_FUZZ_SECONDS:-10}}
examples=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/fuzz/corpus/$name

if [ ! -x "$build/fuzz_$name" ]; then
  echo "skipped: $build/fuzz_$name is not built (clang++ and libclang-rt-14-dev; cmake --preset fuzz)"
  exit 77
fi
# New finds go into a folder of the build and help the next run; the examples stay as they are.
mkdir -p "$build/corpus/$name" "$build/crashes"
# libFuzzer's own exit code for what it finds is 77 as well.
"$build/fuzz_$name" -error_exitcode=1 -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -max_len=65536 \
  -print_final_stats=1 -artifact_prefix="$build/crashes/$name-" "$build/corpus/$name" "$examples" 2>&1 | tail -n 40
