# shellcheck shell=bash
# Sourced after setup.sh by what builds for arm64 on x86-64: defines `arm64` (the build's folder), `arm64_root` (arm64's libraries and their headers)
# and `build_arm64`. Debian's cross compiler is used, and qemu where a program of arm64's runs meanwhile.

arm64=$root/build/arm64
arm64_root=$arm64/root

# need_arm64 STATUS: ends with it where compiler or emulator is missing.
need_arm64() {
    local tool
    for tool in aarch64-linux-gnu-g++ qemu-aarch64-static; do
        command -v $tool >/dev/null || { echo "$tool is missing: apt-get install g++-aarch64-linux-gnu qemu-user-static" >&2; exit "$1"; }
    done
}

# arm64's libraries below $arm64_root, unpacked by an apt of its own, so that this machine's packages stay what they are; and what dpkg knows of
# them: which package a file is of.
fetch_arm64_root() {
    local apt=$arm64/apt known=$arm64_root/var/lib/dpkg release mirror package name link
    release=$(. /etc/os-release && echo "$VERSION_CODENAME")
    rm -rf "$apt" "$arm64_root"
    mkdir -p "$apt"/{state,archives/partial,lists/partial} "$known/info"
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
        catch2 libsimde-dev libstdc++6 libc6-dev povray-includes >&2
    for package in "$apt"/archives/*.deb; do
        dpkg-deb -x "$package" "$arm64_root"
        name=$(dpkg-deb -f "$package" Package)
        [[ $(dpkg-deb -f "$package" Multi-Arch) != same ]] || name+=:arm64
        { dpkg-deb -f "$package" && echo "Status: install ok unpacked" && echo; } >>"$known/status"
        dpkg-deb --fsys-tarfile "$package" | tar -t | sed -e 's/^\.//' -e 's,^/$,/.,' -e 's,\(.\)/$,\1,' >"$known/info/$name.list"
    done
    # Links from / on are meant below the new root.
    find "$arm64_root" -type l -lname '/*' | while read -r link; do ln -sfrn "$arm64_root$(readlink "$link")" "$link"; done
    # What update-alternatives would have set.
    for link in blas lapack; do ln -sfr "$arm64_root/usr/lib/aarch64-linux-gnu/$link/lib$link.so.3" "$arm64_root/usr/lib/aarch64-linux-gnu/"; done
    rm -rf "$apt"
    echo 1 >"$known/info/format"  # names with architectures
    touch "$arm64_root/whole"
}

# build_arm64 TARGET...: without the optimisation of whole programs, which costs g++ as long as all the rest, and without warnings: they are the
# native build's.
build_arm64() {
    [[ -e $arm64_root/whole ]] || fetch_arm64_root
    [[ -f $arm64/build.ninja ]] ||
        cmake -G Ninja -S "$root" -B "$arm64" -DCMAKE_TOOLCHAIN_FILE=cmake/arm64.cmake -DWHITTLE_SYSROOT="$arm64_root" -DCMAKE_BUILD_TYPE=RelWithDebInfo \
            -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O2 -DNDEBUG -w" -DCMAKE_CXX_COMPILER_LAUNCHER="env;CCACHE_DEPEND=1;CCACHE_SLOPPINESS=pch_defines,time_macros;ccache" >&2
    ninja -C "$arm64" --quiet "$@" >&2
}
