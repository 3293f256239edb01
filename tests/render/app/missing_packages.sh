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

# With all packages there, the same scripts go on to configure and build.
stand_in dpkg-query 'printf installed'
PATH="$place/tools:$PATH" "$place/copy/run" >/dev/null 2>&1 || true  # the stand-ins build no program to start
grep -q '^cmake --preset release' "$place/called" && grep -q '^ninja ' "$place/called"
cmp -s "$place/copy/packages.txt" "$place/copy/build/packages.to_run"
