#!/usr/bin/env bash
# arm64.sh [--tests] [SCENE...]: Whittle for arm64, cross-built by Debian's g++ and run by qemu, against this machine's program: pictures of a
# fifth of the golden scenes, or of SCENEs, have the same bytes. With --tests, fast tests run on arm64 too. What it makes stays in
# build/arm64. Ends with 77 where compiler or emulator is missing; the rest it fetches from Debian (some 300 MB, once) without installing it.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/cmake/setup.sh"
folder=$root/build/arm64
sysroot=$folder/root
fast_tests='numbers_v2 numbers_test function_tests test_image shade_test'

for tool in aarch64-linux-gnu-g++ qemu-aarch64-static; do
    command -v $tool >/dev/null || { echo "$tool is missing: apt-get install g++-aarch64-linux-gnu qemu-user-static" >&2; exit 77; }
done

# arm64's libraries below $sysroot: unpacked, with an apt of its own, so that this machine's packages stay what they are.
fetch_root() {
    local apt=$folder/apt release mirror package link
    release=$(. /etc/os-release && echo "$VERSION_CODENAME")
    rm -rf "$apt" "$sysroot"
    mkdir -p "$apt"/{state,archives/partial,lists/partial} "$sysroot"
    : >"$apt/status"
    # Where this machine has its own packages from.
    mirror=$(apt-get indextargets --format '$(REPO_URI)' "Codename: $release" 'Created-By: Packages' | head -n 1)
    echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] ${mirror:?of $release: run apt-get update} $release main" >"$apt/sources.list"
    cat >"$apt/apt.conf" <<EOF
APT::Architecture "arm64";
APT::Architectures { "arm64"; };
APT::Install-Recommends "false";
APT::Sandbox::User "";
Acquire::Languages "none";
Dir::State "$apt/state";
Dir::State::status "$apt/status";
Dir::State::lists "$apt/lists";
Dir::Cache "$apt";
Dir::Cache::archives "$apt/archives";
Dir::Etc::sourceparts "-";
Dir::Etc::sourcelist "$apt/sources.list";
EOF
    APT_CONFIG=$apt/apt.conf apt-get update -q >&2
    # shellcheck disable=SC2046  # a list of names
    APT_CONFIG=$apt/apt.conf apt-get install -q -y --download-only $(packages to_run | tr ' ' '\n' | grep -e '-dev$') \
        catch2 libsimde-dev libstdc++6 libc6-dev >&2
    for package in "$apt"/archives/*.deb; do dpkg-deb -x "$package" "$sysroot"; done
    # Links from / on are meant below the new root.
    find "$sysroot" -type l -lname '/*' | while read -r link; do ln -sfrn "$sysroot$(readlink "$link")" "$link"; done
    rm -rf "$apt"
    touch "$sysroot/whole"
}
[[ -e $sysroot/whole ]] || fetch_root

kernels=own build release whittle
# Without the optimisation of whole programs, which costs g++ as long as all the rest, and without warnings: they are the native build's.
[[ -f $folder/build.ninja ]] ||
    cmake -G Ninja -S "$root" -B "$folder" -DCMAKE_TOOLCHAIN_FILE=cmake/arm64.cmake -DWHITTLE_SYSROOT="$sysroot" -DCMAKE_BUILD_TYPE=RelWithDebInfo \
        -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O2 -DNDEBUG -w" -DCMAKE_CXX_COMPILER_LAUNCHER="env;CCACHE_SLOPPINESS=pch_defines,time_macros;ccache" >&2
with_tests=
[[ ${1:-} != --tests ]] || { with_tests=yes; shift; }
# shellcheck disable=SC2086  # a list of names
ninja -C "$folder" --quiet whittle ${with_tests:+$fast_tests} >&2

emulated="qemu-aarch64-static -L $sysroot"
if [[ -n $with_tests ]]; then
    ctest --test-dir "$folder" -R '^(numbers|numbers/v2|function|image|shade)$' --output-on-failure
fi
if [[ $# -gt 0 ]]; then scenes=("$@"); else scenes=("$root/scenes" --every 5); fi
python3 -B "$root/tests/golden/other_processor.py" "$root/build/release/whittle" "${scenes[@]}" --other "$emulated $folder/whittle" --at-once "$(nproc)"
