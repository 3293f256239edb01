#!/usr/bin/env bash
# cmake/package.sh: installs what is missing, builds, and leaves build/release/whittle_VERSION_amd64.deb.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
install_packages to_package
build release whittle_tools  # and with it the renderer and the modules
# The Python package, where it can be built.
! ninja -C "$root/build/release" -t query whittle_python >/dev/null 2>&1 || build release whittle_python
(cd "$root/build/release" && cpack --config CPackConfig.cmake -B "$root/build/release") >&2
ls "$root"/build/release/whittle_*.deb
