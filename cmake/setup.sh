# SPDX-License-Identifier: GPL-3.0-or-later
# Shared by ./run and ./check: installs what is missing, configures and builds. Sourced, not run.

say() { printf '== %s\n' "$*"; }
fail() {
    printf 'kambara: %s\n' "$*" >&2
    exit 1
}

# packages_for KIND...: the names listed for the kinds.
packages_for() {
    local kind
    for kind in "$@"; do
        awk -v kind="$kind" '$1 == kind { print $2 }' "$ROOT/cmake/packages-debian12.txt"
    done
}

is_installed() {
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# install_missing KIND...: says what it installs before it does. With all there it does nothing and
# uses no network.
install_missing() {
    local missing=() package sudo=()
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "This is no Debian: the packages are not checked. Needed (Debian's names):"
        packages_for "$@" | paste -sd ' '
        return
    fi
    while read -r package; do
        is_installed "$package" || missing+=("$package")
    done < <(packages_for "$@")
    if [ ${#missing[@]} -eq 0 ]; then
        return
    fi
    say "Going to install with apt: ${missing[*]}"
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null ||
            fail "Installing needs root. Run as root: apt-get install --no-install-recommends ${missing[*]}"
        sudo=(sudo)
    fi
    local options=(-y -q --no-install-recommends -o DPkg::Lock::Timeout=600)
    "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=600 update </dev/null ||
        fail "The package lists can't be fetched. Check the network, then try again."
    "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install "${options[@]}" "${missing[@]}" </dev/null ||
        fail "Installing failed. Mend what apt names above, then try again."
}

# build PRESET [TARGET...]: configures build/PRESET and builds it with all cores.
build() {
    local preset=$1
    shift
    local cache="$ROOT/build/$preset/CMakeCache.txt" home
    if [ -f "$cache" ]; then
        home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$cache")
        if [ "$home" != "$ROOT" ]; then
            say "build/$preset belongs to $home: building it anew"
            rm -rf "$ROOT/build/$preset"
        fi
    fi
    say "Configuring the preset $preset"
    (cd "$ROOT" && cmake --preset "$preset" --log-level=WARNING) ||
        fail "Configuring failed: see above."
    say "Building"
    local targets=()
    [ $# -eq 0 ] || targets=(--target "$@")
    (cd "$ROOT" && cmake --build --preset "$preset" -j "$(nproc)" "${targets[@]}") ||
        fail "The build failed: see above."
}
