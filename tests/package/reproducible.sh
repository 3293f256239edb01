#!/usr/bin/env bash
# reproducible.sh FOLDER: Debian package and portable archive of this commit, built here and in a clone in FOLDER (made if it is not there, and
# brought to this commit), have the same bytes.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
clone=${1:?a folder for the clone}
[[ -e $clone ]] || git clone -q "$root" "$clone"
git -C "$clone" fetch -q "$root" HEAD
git -C "$clone" checkout -q FETCH_HEAD
for place in "$root" "$clone"; do
    "$place/cmake/package.sh" >&2
    "$place/cmake/portable.sh" >&2
done
cd "$root/build/release"
for file in whittle_*.deb whittle-*.tar.gz whittle-*.spdx.json; do
    cmp "$file" "$clone/build/release/$file"
    echo "the same bytes: $file"
done
