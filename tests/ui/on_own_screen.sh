#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a program on a virtual screen of its own: on a shared one, two windows take the keyboard
# from each other.
set -euo pipefail

case " $* " in
    *" --gtest_list_tests "*) exec "$@" ;;
esac

coproc SCREEN { exec Xvfb -displayfd 1 -screen 0 1920x1080x24 -nolisten tcp 2>/dev/null; }
trap 'kill "$SCREEN_PID" 2>/dev/null || true' EXIT
if ! read -r -t 60 number <&"${SCREEN[0]}"; then
    printf 'No virtual screen: Xvfb (package xvfb) did not start.\n' >&2
    exit 1
fi
DISPLAY=":$number" "$@"
