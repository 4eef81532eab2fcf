#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# format.sh: fails where a source is not as clang-format would have it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
find app ui core hardware tests -name '*.h' -o -name '*.cpp' | xargs clang-format --dry-run -Werror
