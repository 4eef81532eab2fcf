#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# fuzz.sh BUILD_FOLDER SECONDS: every libFuzzer target for so long, from its corpus.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=${1:?the build folder}
seconds=${2:?seconds for each target}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for target in "$build"/tests/fuzz/*_fuzz; do
    name=$(basename "$target" _fuzz)
    echo "== fuzzing $name for $seconds s"
    mkdir -p "$work/$name"
    (cd "$work" && "$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 \
        -print_final_stats=1 "$work/$name" "$here/corpus/$name")
done
