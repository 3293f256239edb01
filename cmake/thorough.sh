#!/usr/bin/env bash
# What ./check leaves out to be quick. Run it after ./check when you have changed kernels or code that handles memory: it builds all
# kernels that this processor runs and repeats the tests that compare them, runs the fast tests with the address and
# undefined-behaviour sanitizers, and lets g++ read every source.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
install_packages to_check
kernels=runnable build release all
ctest --test-dir "$root/build/release" --output-on-failure -j"$(nproc)" -L every_kernel
build sanitize sanitized_tests
ctest --test-dir "$root/build/sanitize" --output-on-failure -j"$(nproc)" -L sanitized
"$root/cmake/second_compiler.py"
echo "all thorough checks passed"
