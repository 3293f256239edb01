#!/usr/bin/env bash
# cmake/portable.sh [FOLDER]: installs what is missing, builds, and leaves whittle-VERSION-linux-MACHINE.tar.gz, its checksum and its bill of
# materials in FOLDER (build/release).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
install_packages to_package
build release whittle_tools  # and with it the renderer and the modules
"$root/packaging/portable.py" "$root/build/release" ${1:+"$1"}
