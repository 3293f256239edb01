# shellcheck shell=bash
# Sourced by ./run where nothing is compiled yet. Optimisation is most of a compiler's time and a first picture is small, so a
# program without it draws before the fast one is compiled: preset `quick`, the same bytes, a hundred times as slow; no cache
# keeps it, which would take its time too. A picture that takes a minute or more is raced by the compiler, so that nobody waits
# for a slow program's slow scene.

# first_picture SCENE OPTION...: ends the script with the picture's status, or returns where the fast program,
# which then continues the picture, is there before it.
first_picture() {
    # shellcheck disable=SC2154  # root: setup.sh
    local fast=$root/build/release drawing building='' patience first status=0
    export kernels=own
    echo "whittle: compiling without optimisation for the first picture (two to three minutes on two cores)" >&2
    build quick whittle
    "$root/build/quick/whittle" "$@" &
    drawing=$!
    sleep 60 &
    patience=$!
    trap 'kill "$drawing" "$patience" $building 2>/dev/null || true' EXIT
    wait -n -p first "$drawing" "$patience" || status=$?
    if [[ $first != "$drawing" ]]; then
        echo "whittle: still drawing; the fast program is compiled beside it" >&2
        configure release
        nice -n 10 ninja -C "$fast" --quiet whittle >&2 &
        building=$!
        wait -n -p first "$drawing" "$building" || status=$?
    fi
    # A mistake in the scene, say: it is mended before anything else is compiled.
    [[ $status == 0 ]] || exit "$status"
    if [[ $first == "$building" ]]; then
        { kill "$drawing" && wait "$drawing"; } || true  # leaves what is drawn for +C
    else
        echo "whittle: the picture is there; now the fast program (four minutes more; where you stop it, the next ./run goes on)" >&2
        kill "$patience" $building 2>/dev/null || true
        wait
        build release whittle
    fi
    trap - EXIT
    rm -rf "$root/build/quick"
    [[ $first == "$building" ]] || exit 0
}
