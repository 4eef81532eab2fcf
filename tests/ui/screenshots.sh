#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# screenshots.sh [FOLDER]: the window in every state and on screens of several sizes, as pictures
# in FOLDER (build/screenshots unless given). Needs a release build.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=${1:-$root/build/screenshots}
program=$root/build/release/tests/ui/kambara-screenshots
mkdir -p "$folder"

on_screen() {
    xvfb-run -a -s "-screen 0 ${1}x24" "$program" "$folder" "${@:2}"
}

on_screen 1600x950 simulated recording lost no-gl levelling range head
on_screen 1024x600 small-1024x600
KAMBARA_LANGUAGE=de on_screen 1600x950 german german-levelling german-range german-head
QT_SCALE_FACTOR=2 on_screen 3840x2160 large-3840x2160-at-200
