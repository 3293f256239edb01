#!/bin/sh
# where_supported.sh LEVEL PROGRAM: runs it where the processor has this level of x86-64, else ends with 77. The program cannot ask by
# itself: what its compiler makes of its beginning has that level's instructions already.
/lib64/ld-linux-x86-64.so.2 --help | grep -q "x86-64-$1 (supported" || exit 77
exec "$2"
