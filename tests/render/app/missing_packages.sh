#!/usr/bin/env bash
# missing_packages.sh ROOT: ./run and ./check on a machine that lacks packages, for a user who is not root, print the exact
# command and stop. A copy of the scripts is called with stand-ins for the system's tools first in PATH, so nothing is
# installed, configured or built.
set -euo pipefail
root=$1
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
mkdir -p "$place/copy/cmake" "$place/tools"
cp "$root/run" "$root/check" "$root/packages.txt" "$place/copy"
cp "$root/cmake/setup.sh" "$place/copy/cmake"

stand_in() { printf '#!/bin/sh\n%s\n' "$2" >"$place/tools/$1"; chmod +x "$place/tools/$1"; }
# dpkg-query -W -f=FORMAT NAME: two of the packages are not there, the second in the way of one removed but not purged.
# shellcheck disable=SC2016  # for the stand-in's shell
stand_in dpkg-query 'case $3 in libglm-dev) exit 1 ;; catch2) printf config-files ;; *) printf installed ;; esac'
stand_in id 'echo 1000'
# shellcheck disable=SC2016
for tool in apt-get sudo cmake ninja; do stand_in "$tool" 'echo "${0##*/} $*" >>"${0%/*}/../called"'; done

# A compiler that is there is what counts: nothing is asked for another.
for script in run check; do
    lacking=libglm-dev
    [[ $script == check ]] && lacking+=" catch2"  # what only the tests need does not keep a picture waiting
    expected="packages are missing; install them with:
  sudo apt-get update && sudo apt-get install --no-install-recommends $lacking"
    status=0
    said=$(PATH="$place/tools:$PATH" "$place/copy/$script" 2>&1) || status=$?
    if [[ $status != 1 || $said != "$expected" || -e $place/called ]]; then
        printf '%s: exit status %s, called: %s\n%s\n' "$script" "$status" "$(cat "$place/called" 2>/dev/null)" "$said"
        exit 1
    fi
done

# Of the compilers the newest clang that is there, with what belongs to it; g++ where there is none; the system's clang where there is
# neither, and its own is as good as one of the names with a number.
compilers() {
    # shellcheck disable=SC2016
    stand_in dpkg-query 'for there in '"$1"'; do [ "$3" = "$there" ] && { printf installed; exit; }; done; exit 1'
    (PATH="$place/tools:$PATH"; source "$place/copy/cmake/setup.sh"; packages to_run | head -1)
}
expect() { [[ $(compilers "$1") == "$2" ]] || { echo "with '$1' installed: $(compilers "$1"), not $2"; exit 1; }; }
expect "clang-14 g++" "clang-14 lld-14 llvm-14"
expect "clang-14 clang clang-19 g++" "clang-19 lld-19 llvm-19"
expect "g++ clang" "clang lld llvm"
expect "g++ lld-14" "g++"
expect "" "clang lld llvm"

# With all packages there, the same scripts go on to configure and build.
stand_in dpkg-query 'printf installed'
PATH="$place/tools:$PATH" "$place/copy/run" >/dev/null 2>&1 || true  # the stand-ins build no program to start
grep -q '^cmake --preset release --fresh' "$place/called" && grep -q '^ninja ' "$place/called"
cat "$place/copy/packages.txt" /etc/os-release | cmp -s - "$place/copy/build/packages.to_run"
