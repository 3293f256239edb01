#!/usr/bin/env bash
# portable.sh [FOLDER]: builds the portable archive, packs it twice, and runs it in bare roots of Debian 11, 12 and 13, made in FOLDER (a temporary
# one if none is given): pictures have the bytes of the program that was packed. As root; needs debootstrap.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/tests/package/bare_root.sh"
folder=${1:-$(mktemp -d)}
trap '[[ $# -gt 0 ]] || rm -rf --one-file-system "$folder"' EXIT
expect() { "$@" || { echo "failed: $*" >&2; exit 1; }; }

SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$root" log -1 --format=%ct)}  # of both
export SOURCE_DATE_EPOCH
archive=$("$root/cmake/portable.sh" "$folder/one")
"$root/packaging/portable.py" "$root/build/release" "$folder/two" >/dev/null
expect diff -r "$folder/one" "$folder/two"  # byte for byte
(cd "$folder/one" && expect sha256sum --quiet --check ./*.sha256)

scenes=$folder/scenes
rm -rf "$scenes"
python3 -B "$root/tests/package/portable_scenes.py" "$root/build/release/whittle" "$scenes"
for release in bullseye bookworm trixie; do
    bare_root $release "$folder/$release"
    rm -rf "$place"/root/* "$place"/opt/* "$place"/usr/local/bin/*
    tar -xf "$archive" -C "$place/opt"
    unpacked=/opt/$(basename "$archive" .tar.gz)
    ln -s "$unpacked/bin/whittle" "$place/usr/local/bin/whittle"
    ln -s whittle "$place/usr/local/bin/povray"
    cp -r "$scenes" "$place/root/scenes"
    # shellcheck disable=SC2016  # for the shell within
    inside env PATH=/usr/local/bin:/usr/bin:/bin bash -c '
        set -e
        cd /root/scenes
        for scene in *.pov; do whittle $scene +W64 +H48 +O/root/${scene%.pov}.png 2>/root/said || { cat /root/said; exit 1; }; done
        for type in J T C B H; do  # JPEG, Targa in two forms, BMP, Radiance
            whittle includes.pov +W64 +H48 +F$type +O/root/type$type 2>/root/said || { cat /root/said; exit 1; }
        done
        povray +Iincludes.pov +W64 +H48 +O/root/called.png 2>/dev/null
        cd /root
        whittle mesh scenes/includes.pov -o d.stl >/dev/null 2>&1
        test -s d.stl
        whittle pixel scenes/includes.pov 3,4 +W64 +H48 >/dev/null
        for kernel in "$0"/lib/whittle/libwhittle_kernel_v[23].so; do  # that any processor of today has
            level=${kernel##*_}
            whittle scenes/includes.pov +W64 +H48 --isa=${level%.so} +O$level.png 2>/dev/null
            cmp $level.png includes.png
        done
        whittle watch scenes/includes.pov >said 2>&1 & watching=$!
        for try in 1 2 3 4 5 6 7 8 9 10; do grep -q http://127.0.0.1 said && break; sleep 0.3; done
        port=$(sed -nE "s|.*http://127.0.0.1:([0-9]+)/.*|\1|p" said)
        token=$(sed -nE "s|.*http://127.0.0.1:[0-9]+(/[^ ]*/).*|\1|p" said)
        exec 3<>/dev/tcp/127.0.0.1/$port
        printf "GET %s HTTP/1.1\r\nHost: 127.0.0.1:%s\r\nConnection: close\r\n\r\n" "$token" "$port" >&3
        grep -q "200 OK" <&3
        kill $watching' "$unpacked"
    for picture in "$scenes"/*.png; do
        case $picture in */expected_*) ;; *) continue ;; esac
        expect cmp "$picture" "$place/root/$(basename "${picture#*expected_}")"
    done
    expect cmp "$place/root/called.png" "$scenes/expected_includes.png"
    for type in J.jpg T.tga C.tga B.bmp H.hdr; do
        [[ -e $scenes/type$type ]] || "$root/build/release/whittle" "$scenes/includes.pov" +W64 +H48 "+F${type%.*}" "+O$scenes/type$type" 2>/dev/null
        expect cmp "$scenes/type$type" "$place/root/type$type"
    done
    echo "runs in $release, $(inside /bin/sh -c 'ldd --version | head -1')"
done
