#!/usr/bin/env bash
# clean_root.sh [bookworm|trixie [FOLDER]]: builds the package on that release (in a minimal Debian of its own, of a clone, where it is not this
# machine's), installs it in a clean one, renders there, and removes it again. Both are made in FOLDER (a temporary one if none is given). As root;
# needs debootstrap.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/tests/package/bare_root.sh"
here=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
release=${1:-$here}
folder=${2:-$(mktemp -d)}
trap '[[ $# -gt 1 ]] || rm -rf --one-file-system "$folder"' EXIT
if [[ $release == "$here" ]]; then
    package=$("$root/cmake/package.sh")
else
    bare_root "$release" "$folder/build"
    inside apt-get update -q >&2
    rm -rf "$place/root/whittle"
    git clone -q "$root" "$place/root/whittle"
    package=$place$(inside bash -c 'cd /root/whittle && cmake/package.sh')
fi
bare_root "$release" "$folder/clean"
inside apt-get update -q >&2
cp "$package" "$place/root/whittle.deb"
cp "$root/scenes/first_light.pov" "$place/root/"
expect() { "$@" || { echo "failed: $*" >&2; exit 1; }; }
inside apt-get install -q -y --no-install-recommends /root/whittle.deb >&2
for file in bin/whittle bin/povray-whittle bin/povray share/man/man1/whittle.1 share/bash-completion/completions/whittle \
    share/zsh/vendor-completions/_whittle share/applications/whittle.desktop share/mime/packages/whittle.xml \
    share/whittle/editors/nvim/lua/whittle.lua share/whittle/editors/emacs/pov-scene-mode.el share/whittle/editors/vscode/package.json; do
    expect test -e "$place/usr/$file" -o -L "$place/usr/$file"
done
inside whittle --version
inside whittle /root/first_light.pov +W80 +H60 +O/root/a.png 2>/dev/null
inside povray +I/root/first_light.pov +W80 +H60 +O/root/b.png 2>/dev/null
expect cmp "$place/root/a.png" "$place/root/b.png"
inside whittle /root/first_light.pov +W80 +H60 --aov=depth +FE +O/root/c.exr 2>/dev/null
expect test -s "$place/root/c.layers.exr"
inside whittle mesh /root/first_light.pov -o /root/d.stl >&2  # which whittle_tools does
expect test -s "$place/root/d.stl"
inside apt-get remove -q -y whittle >&2
for file in bin/whittle bin/povray lib/whittle share/whittle share/man/man1/whittle.1; do expect test ! -e "$place/usr/$file"; done
rm "$place"/root/*.png "$place"/root/*.exr "$place"/root/*.stl
echo "built, installed, run and removed on $release: $(basename "$package")"
