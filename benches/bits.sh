#!/usr/bin/env bash
# Checks that the bits of answers at f64 depend neither on the compilation target nor on batches: builds
# benches/bits.rs for each target given, by default x86-64, x86-64-v3 and this processor, and compares the outputs:
# benches/bits.sh [POINTS [TARGET…]], with 100000 points by default.
set -euo pipefail
cd "$(dirname "$0")/.."
points=${1:-100000}
bits() { # TARGET
    # The compiler's default target shares its build with the other benchmarks.
    [ "$1" != x86-64 ] || { cargo bench --quiet -p stickslip-benches --features batch --bench bits -- "$points"; return; }
    # These settings shorten the compilation; the bits do not depend on them.
    RUSTFLAGS="-C target-cpu=$1" CARGO_TARGET_DIR="target/bits-$1" CARGO_PROFILE_BENCH_LTO=off CARGO_PROFILE_BENCH_CODEGEN_UNITS=16 \
        CARGO_PROFILE_BENCH_OPT_LEVEL=1 cargo bench --quiet -p stickslip-benches --features batch --bench bits -- "$points"
}
first=""
shift || true
[ $# -gt 0 ] || set -- x86-64 x86-64-v3 native
for target; do
    echo "$target:"
    found=$(bits "$target")
    echo "$found"
    [ -z "$first" ] || [ "$found" = "$first" ] || { echo "$target gives other bits than x86-64"; exit 1; }
    first=$found
done
