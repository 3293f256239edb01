#!/usr/bin/env bash
# cmake/package.sh [--arm64]: installs what is missing, builds, and leaves whittle_VERSION_amd64.deb in build/release. --arm64: for arm64, in
# build/arm64, by Debian's cross compiler and qemu, which are not installed by this; without the Python package.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
install_packages to_package
if [[ ${1:-} == --arm64 ]]; then
    source "$root/cmake/arm64.sh"
    need_arm64 1
    build_arm64 whittle whittle_tools
    built=$arm64
    # dpkg-shlibdeps knows this machine's libraries alone.
    libraries=$("$root/packaging/libraries.py" "$built" "$built"/whittle "$built"/whittle_tools "$built"/libwhittle_*.so)
    settings=(-D CPACK_DEBIAN_PACKAGE_ARCHITECTURE=arm64 -D CPACK_DEBIAN_PACKAGE_SHLIBDEPS=OFF -D "CPACK_DEBIAN_PACKAGE_DEPENDS=$libraries")
else
    build release whittle_tools  # and with it the renderer and the modules
    built=$root/build/release settings=()
    # The Python package, where it can be built.
    ! ninja -C "$built" -t query whittle_python >/dev/null 2>&1 || build release whittle_python
fi
# The same commit gives the same bytes.
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$root" log -1 --format=%ct 2>/dev/null || date +%s)}
(cd "$built" && cpack --config CPackConfig.cmake -B "$built" "${settings[@]}") >&2
ls "$built"/whittle_*.deb
