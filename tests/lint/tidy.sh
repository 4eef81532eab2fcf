#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# tidy.sh BUILD_FOLDER: clang-tidy over every source of the build's compile_commands.json.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${1:?the build folder}
cd "$root"
git ls-files 'app/*.cpp' 'core/*.cpp' 'hardware/*.cpp' |
    xargs -P "$(nproc)" -n 4 clang-tidy --quiet -p "$build"
