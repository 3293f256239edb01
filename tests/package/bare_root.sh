# shellcheck shell=bash
# Sourced: bare_root RELEASE FOLDER sets `place` to a minimal Debian in FOLDER, `inside COMMAND...` runs as root in it.

# Makes the root by debootstrap unless it is there, with this machine's mirror and settings of apt.
bare_root() {
    local mirror
    place=$(realpath -m "$2")
    if [[ ! -e $place/usr/bin/apt-get ]]; then
        mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/*.sources 2>/dev/null | sed -nE 's/^(URIs:|deb( \[[^]]*\])?) *([^ ]+).*/\3/p' | head -1 || true)
        debootstrap --variant=minbase "$1" "$place" "$mirror" >&2
    fi
    grep -q "^VERSION_CODENAME=$1$" "$place/etc/os-release" || { echo "$place is no $1" >&2; exit 1; }
    cp /etc/apt/apt.conf.d/* "$place/etc/apt/apt.conf.d/" 2>/dev/null || true
    cp /etc/resolv.conf "$place/etc/" 2>/dev/null || true
}

# What is mounted for it is in a namespace of its own, and so are its processes: neither outlives the command, however that ends.
inside() {
    # shellcheck disable=SC2016  # for the shell within
    unshare --mount --pid --fork --kill-child bash -c '
        set -e
        mount -t proc proc "$0/proc"
        mount -t sysfs -o ro sysfs "$0/sys"
        mount -t devpts -o newinstance,ptmxmode=0666 devpts "$0/dev/pts"
        mkdir -p "$0/dev/shm"
        mount -t tmpfs tmpfs "$0/dev/shm"
        exec chroot "$0" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C DEBIAN_FRONTEND=noninteractive "$@"' "$place" "$@"
}
