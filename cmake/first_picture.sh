# shellcheck shell=bash
# Sourced by ./run where nothing is compiled yet. Optimisation is most of a compiler's time and a first picture is small: a program without it
# (preset `quick`: the same bytes, some fifty times as slow) draws while the fast one is compiled. Whichever is done first gives
# the picture, so that nobody waits for a slow program's slow scene.

# first_picture SCENE OPTION...: ends the script with the picture's status, or returns where the fast program,
# which then continues it, is there before.
first_picture() {
    # shellcheck disable=SC2154  # root: setup.sh
    local drawing building first status=0 fast=$root/build/release
    export kernels=own
    echo "whittle: compiling without optimisation for the first picture (two minutes on two cores)" >&2
    build quick whittle
    echo "whittle: drawing, and compiling the fast program (four minutes on two cores; where you stop it, the next ./run goes on)" >&2
    configure release
    nice -n 19 ninja -C "$fast" --quiet whittle >&2 &
    building=$!
    "$root/build/quick/whittle" "$@" &
    drawing=$!
    trap 'kill "$drawing" "$building" 2>/dev/null || true' EXIT
    wait -n -p first "$drawing" "$building" || status=$?
    if [[ $first == "$drawing" ]]; then
        [[ $status == 0 ]] || exit "$status"  # a mistake in the scene, say: it is mended meanwhile
        echo "whittle: the picture is there; compiling goes on" >&2
        wait "$building" || status=$?
    elif [[ $status == 0 ]]; then
        { kill "$drawing" && wait "$drawing"; } || true  # leaves what is drawn for +C
    fi
    [[ $status == 0 ]] || exit "$status"
    trap - EXIT
    rm -rf "$root/build/quick"
    [[ $first != "$drawing" ]] || exit 0
}
