#!/usr/bin/env bash
# debian.sh bookworm|trixie [FOLDER]: a clone of this repository in a minimal Debian 12 or 13, and both commands of the README there. What is
# not committed is not tried. The root is made in FOLDER and kept (a temporary one if none is given); as root; needs debootstrap.
# The sums of its pictures (tests/golden/sums.py) are left in build/pictures.RELEASE and compared with the other release's if they are there.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/tests/package/bare_root.sh"
case ${1:-} in
bookworm) other=trixie ;;
trixie) other=bookworm ;;
*) echo "usage: debian.sh bookworm|trixie [FOLDER]" >&2; exit 2 ;;
esac
folder=${2:-$(mktemp -d)}
trap '[[ $# -gt 1 ]] || rm -rf --one-file-system "$folder"' EXIT
bare_root "$1" "$folder"
rm -rf "$place/root/whittle"
git clone -q "$root" "$place/root/whittle"

started=$(date +%s)
step() { echo "$(($(date +%s) - started)) s: $*"; }
inside bash -c 'cd /root/whittle && ./run scenes/first_light.pov'
test -s "$place/root/whittle/scenes/first_light.png"
step "./run has rendered"
inside bash -c 'cd /root/whittle && ./check'
step "./check has passed"

# No compiler or library of a release may change a picture.
sums=$root/build/pictures
mkdir -p "$root/build"
inside bash -c 'cd /root/whittle && tests/golden/sums.py build/release/whittle' >"$sums.$1"
if [[ -e $sums.$other ]]; then
    diff "$sums.$1" "$sums.$other" || { echo "pictures differ from $other's" >&2; exit 1; }
    step "$(grep -c . "$sums.$1") pictures have the same bytes on $other"
fi
