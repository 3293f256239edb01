#!/usr/bin/env bash
# cmake/portable.sh [--arm64] [FOLDER]: installs what is missing, builds, and leaves whittle-VERSION-linux-MACHINE.tar.gz, its checksum and its bill of
# materials in FOLDER (the build's). --arm64: for arm64, by Debian's cross compiler and qemu, which are not installed by this.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
install_packages to_package
if [[ ${1:-} == --arm64 ]]; then
    shift
    source "$root/cmake/arm64.sh"
    need_arm64 1
    build_arm64 whittle whittle_tools
    built=$arm64
else
    build release whittle_tools  # and with it the renderer and the modules
    built=$root/build/release
fi
"$root/packaging/portable.py" "$built" ${1:+"$1"}
