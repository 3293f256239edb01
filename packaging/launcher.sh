#!/bin/sh
# Starts PROGRAM with the C library and the other libraries that it was built with, whatever this system has. Programs that it starts get none of
# them: they are named to the loader, not by the environment.
WHITTLE_LAUNCHER=$(readlink -f -- "$0")
export WHITTLE_LAUNCHER
folder=${WHITTLE_LAUNCHER%/*}/../lib/whittle
[ -d "$folder/libraries" ] || folder=${WHITTLE_LAUNCHER%/*}
libraries=$folder/libraries
exec "$libraries/LOADER" --inhibit-cache --library-path "$libraries" --argv0 "$0" "$folder/programs/PROGRAM" "$@"
