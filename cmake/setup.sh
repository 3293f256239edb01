# shellcheck shell=bash
# Sourced by ./run and ./check: packages, configuration. Defines `root`, `install_packages` and `build`.
# A second call costs a comparison of small files, which starts no program, and one look of Ninja at the sources.

root=$(cd "${BASH_SOURCE[0]%/*}/.." && pwd)

# A file's text in REPLY, empty if there is none.
contents() { REPLY='' && { [[ ! -r $1 ]] || IFS= read -r -d '' REPLY <"$1" || true; }; }

installed() { [[ $(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]; }

# choice 'a b | *c d | e': the packages of the first alternative whose first one is installed, else those of the one with a star.
choice() {
    local alternatives alternative names starred=
    IFS='|' read -r -a alternatives <<<"$1"
    for alternative in "${alternatives[@]}"; do
        read -r -a names <<<"${alternative/'*'/}"
        if installed "${names[0]}"; then echo "${names[*]}"; return; fi
        [[ $alternative != *'*'* ]] || starred=${names[*]}
    done
    echo "$starred"
}

# The names in packages.txt that a purpose needs: to_run, to_check or to_package.
packages() {
    local left_out line
    case $1 in
    to_run) left_out='test|package' ;;
    to_check) left_out=package ;;
    to_package) left_out='test' ;;
    esac
    sed -E -e "/^# To ($left_out)/,/^\$/d" -e 's/#.*//' -e '/^[[:space:]]*$/d' "$root/packages.txt" | while read -r line; do
        if [[ $line == *'|'* ]]; then choice "$line"; else echo "$line"; fi
    done
}

# Those of them that are not installed, on one line.
missing_packages() {
    local name names=()
    for name in $(packages "$1"); do installed "$name" || names+=("$name"); done
    echo "${names[*]}"
}

# install_packages PURPOSE: a browser and an editor are for the tests alone, for one.
install_packages() {
    local stamp=$root/build/packages.$1 missing wanted=
    contents "$root/packages.txt" && wanted=$REPLY
    contents /etc/os-release && wanted+=$REPLY
    contents "$stamp" && [[ $REPLY == "$wanted" ]] && return
    command -v dpkg-query >/dev/null || { echo "this needs packages of Debian 12 or 13: $(packages "$1" | tr '\n' ' ')" >&2; exit 1; }
    missing=$(missing_packages "$1")
    if [[ -n $missing ]]; then
        if [[ $(id -u) != 0 ]]; then
            echo "packages are missing; install them with:" >&2
            echo "  sudo apt-get update && sudo apt-get install --no-install-recommends $missing" >&2
            exit 1
        fi
        apt-get update -q >&2
        # shellcheck disable=SC2086  # a list of names
        DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing >&2
    fi
    mkdir -p "$root/build"
    printf %s "$wanted" >"$stamp"
}

# kernels_for HAD KIND: those to build, by level of x86-64: all of them; those that this processor runs, since no test sees the others
# (`runnable`); the best of these (`own`). Those that are configured already stay where they serve.
kernels_for() {
    local had=$1 levels wanted
    levels=$({ /lib64/ld-linux-x86-64.so.2 --help 2>/dev/null || true; } | sed -n 's/.*x86-64-\(v[234]\) (supported.*/\1/p' | sort)
    levels=${levels:-v2}
    case $2 in
    own) wanted=${had:-${levels##*$'\n'}} ;;
    runnable) wanted=$levels ;;
    *) wanted="v2;v3;v4" ;;
    esac
    wanted=${wanted//$'\n'/;}
    # In order, so that all of them with others between match too.
    if [[ $had == *${wanted//;/*}* ]]; then echo "$had"; else echo "$wanted"; fi
}

# configure PRESET: when packages came since the last time (Ninja itself does when a CMake file changed). Afresh, for the compiler
# and what was found may have gone with an older Debian.
configure() {
    local folder=$root/build/$1 stamp wanted='' had='' levels
    contents "$folder/CMakeCache.txt"
    [[ ! $REPLY =~ $'\nWHITTLE_ISA_LEVELS:STRING='([^$'\n']*) ]] || had=${BASH_REMATCH[1]}
    levels=$(kernels_for "$had" "${kernels:-}")
    [[ $levels == "$had" && -f $folder/build.ninja ]] || wanted=yes
    for stamp in "$root"/build/packages.*; do
        [[ $stamp -nt $folder/build.ninja ]] && wanted=yes
    done
    [[ -z $wanted ]] || (cd "$root" && cmake --preset "$1" --fresh -DWHITTLE_ISA_LEVELS="$levels") >&2
}

# build PRESET TARGET...: configured where it has to be; quiet when there is nothing to do.
build() {
    configure "$1"
    ninja -C "$root/build/$1" --quiet "${@:2}" >&2
}
