#!/usr/bin/env bash
# What ./check leaves out to be short, for continuous integration and for whoever touches kernels, memory or what a compiler may
# refuse: all kernels that this processor runs with the tests that look at them, the fast tests with the address and
# undefined-behaviour sanitizers, and what g++ says of every source. After ./check, whose build it goes on with.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
install_packages to_check
kernels=runnable build release all
ctest --test-dir "$root/build/release" --output-on-failure -j"$(nproc)" -L every_kernel
build sanitize sanitized_tests
ctest --test-dir "$root/build/sanitize" --output-on-failure -j"$(nproc)" -L sanitized
"$root/cmake/second_compiler.py"
echo "all thorough checks passed"
