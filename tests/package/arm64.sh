#!/usr/bin/env bash
# arm64.sh [--tests] [--package] [--archive] [SCENE...]: Whittle for arm64, cross-built by Debian's g++ and run by qemu, against this machine's
# program: pictures of a fifth of the golden scenes, or of SCENEs, have the same bytes. With --tests, fast tests run on arm64 too; with --package or
# --archive, the pictures are those of the program in the Debian package or the portable archive. What it makes stays in build/arm64. Ends with 77
# where compiler or emulator is missing; the rest it fetches from Debian (some 170 MB, once) without installing it.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../cmake/setup.sh"
source "$root/cmake/arm64.sh"
need_arm64 77

kernels=own build release whittle
build_arm64 whittle
emulated=(qemu-aarch64-static -L "$arm64_root")
program="${emulated[*]} $arm64/whittle"
while [[ ${1:-} == --* ]]; do
    case $1 in
    --tests)
        build_arm64 numbers_v2 numbers_test function_tests test_image shade_test
        ctest --test-dir "$arm64" -R '^(numbers|numbers/v2|function|image|shade)$' --output-on-failure
        ;;
    --package)
        rm -rf "$arm64/package"
        dpkg-deb -x "$("$root/cmake/package.sh" --arm64)" "$arm64/package"
        program="${emulated[*]} $arm64/package/usr/bin/whittle"
        ;;
    --archive)
        archive=$("$root/cmake/portable.sh" --arm64)
        tar -xf "$archive" -C "$arm64"
        # As its launcher calls it, the archive's own loader and libraries; nothing of the root that it was built with.
        lib=$arm64/$(basename "$archive" .tar.gz)/lib/whittle
        start="$lib/libraries/ld-linux-aarch64.so.1 --inhibit-cache --library-path $lib/libraries $lib/programs"
        program="env WHITTLE_LAUNCHER=$lib/whittle qemu-aarch64-static $start/whittle"
        # shellcheck disable=SC2086  # words
        env WHITTLE_LAUNCHER="$lib/whittle_tools" qemu-aarch64-static $start/whittle_tools mesh "$root/scenes/first_light.pov" -o "$arm64/mesh.stl"
        test -s "$arm64/mesh.stl"
        ;;
    *) echo "usage: arm64.sh [--tests] [--package] [--archive] [SCENE...]" >&2; exit 2 ;;
    esac
    shift
done
if [[ $# -gt 0 ]]; then scenes=("$@"); else scenes=("$root/scenes" --every 5); fi
python3 -B "$root/tests/golden/other_processor.py" "$root/build/release/whittle" "${scenes[@]}" --other "$program" --at-once "$(nproc)"
